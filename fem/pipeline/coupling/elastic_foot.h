#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/foot_specification.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Solved contacts of one foot, from which the next contact is predicted.
class ContactPath
{
public:
  /// Returns the initial guess of the contact under @p demand at @p slip, from contacts with the same
  /// orientation of glass and table. `previous`: @p before, or the last contact if nullptr. `predicted`: the
  /// polynomial in the spin through the nearest contacts under the same demand or at rest. If fewer than two
  /// exist, or if contacts of the similar foot are much nearer, the polynomial passes through the contacts of
  /// the similar foot. If it has none, `predicted` is the nearest contact.
  fem::ContactGuess guess(const fem::ContactDemand &demand, const ring::Slip &slip,
                          const fem::ContactState *before = nullptr) const;

  /// Returns the contact at the spin nearest to @p slip, between rest and @p slip, if any, of the same
  /// orientation of glass and table and the same @p zone.
  std::optional<fem::ContactStart> nearest_towards_rest(const ring::Slip &slip, unsigned int zone) const;

  /// Appends a solved contact.
  void append(const fem::ContactState &state);

  /// Adds predictions for the foot @p own from the contacts in @p similar, the path of the foot @p other.
  void predict_from_similar(const ContactPath &similar, const fem::Foot &own, const fem::Foot &other);

private:
  /// Contact with its demand and slip.
  struct Found
  {
    explicit Found(const fem::ContactState &state);

    /// Normal force, moment and tilt moment; not the moment of friction, which depends on the spin.
    Eigen::Vector4d demand;
    ring::Slip slip;
    unsigned int zone; ///< ContactState::zone
    fem::ContactStart start;
  };

  /// Returns the polynomial through the nearest of @p points at @p spin, if @p n_least or more can be used.
  static std::optional<fem::ContactStart> between(std::vector<const Found *> points, double spin,
                                                  std::size_t n_least);

  /// Returns the start predicted at @p slip from @p own contacts or from contacts of the similar foot.
  std::optional<fem::ContactStart> expected(const std::vector<const Found *> &own,
                                            const ring::Slip &slip) const;

  std::optional<fem::ContactState> last;
  std::vector<Found> recent;            ///< oldest first
  std::vector<Found> from_similar_foot; ///< predictions added by predict_from_similar()
};

/// Elastic foot of a study, whose contacts are projected onto the same rings and harmonics. Not thread-safe.
class ElasticFoot
{
public:
  ElasticFoot(std::shared_ptr<const fem::Foot> foot, FootSpecification specification);

  /// Returns study, discretisation and model of the foot.
  const FootSpecification &specification() const { return made_from; }
  /// Returns the contact radius R of the moment ratio [m].
  double radius() const { return made_from.study.glass.profile.contact_radius; }

  /// Returns the radii of the rings [m]; empty: a single ring, whose radius follows from the load.
  const std::vector<double> &ring_radii() const { return radii; }
  /// Returns the highest harmonic of its loads.
  unsigned int n_harmonics() const { return highest; }
  void set_rings(std::vector<double> new_radii, unsigned int n_harmonics);
  bool has_rings() const { return placed; }
  /// Undoes set_rings(), so that rings can be chosen anew.
  void reset_rings();
  /// Returns a copy with its own body for another thread, as a foot of @p study; its path starts as a copy of
  /// this foot's path. Precondition: the feet of both studies have the same body.
  std::shared_ptr<ElasticFoot> clone(Study study) const;

  /// Returns the contact under @p demand at @p slip, projected onto ring_radii(). @p before: initial guess;
  /// nullptr: last contact. @p progress receives the Newton steps. Throws fem::ContactFailure.
  fem::ContactState solve(fem::ContactDemand demand, const ring::Slip &slip = {},
                          Progress &progress = silent_progress(), const fem::ContactState *before = nullptr);

  /// Predicts initial guesses of contacts from the contacts of @p similar, the foot of a similar study.
  void predict_from_similar(const ElasticFoot &similar);

  /// Returns solve() at rest; caches the last result.
  fem::ContactState solve_at_rest(const fem::ContactDemand &demand, const ring::Orientation &marks,
                                  Progress &progress);

  /// Projects the load of @p state, a contact of this foot, onto ring_radii().
  fem::ContactLoad project_onto_rings(const fem::ContactState &state) const
  {
    return foot->project_onto_rings(state, radii, highest);
  }

  const fem::Foot &body() const { return *foot; }

private:
  std::shared_ptr<const fem::Foot> foot;
  FootSpecification made_from;
  std::vector<double> radii;
  unsigned int highest;
  bool placed = false; ///< true after set_rings()
  ContactPath path;
  std::optional<fem::ContactState> at_rest; ///< last result of solve_at_rest()
};

/// Makes the body of a foot on its table; results depend on the specification only. The body may share data
/// with @p similar (or nullptr), which must not be used while the body solves.
using FootMaker =
  std::function<std::shared_ptr<fem::Foot>(const FootSpecification &, const fem::Foot *similar)>;

/// Returns a foot made by @p make_foot; nullptr for a load without a contact. Initial guesses are predicted
/// from the contacts of @p similar, if given. Throws as @p make_foot.
std::shared_ptr<ElasticFoot> study_foot(const FootSpecification &specification, const FootMaker &make_foot,
                                        Progress &progress = silent_progress(),
                                        const ElasticFoot *similar = nullptr);

/// Returns @p n_rings Chebyshev points of the band from @p inner to @p outer [m], ascending.
std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings);

} // namespace stemware::pipeline
