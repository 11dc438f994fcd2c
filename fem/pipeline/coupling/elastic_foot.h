#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/contact_path.h"
#include "fem/pipeline/coupling/foot_specification.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

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
