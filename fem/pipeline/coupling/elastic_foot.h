#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/contact_path.h"
#include "fem/pipeline/support/progress.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The elastic foot of a study as the ring sees it: demands and slip in, contacts out, whose load is gathered
/// on rings of the same radii and harmonics for all of them. Not for several threads at a time.
class ElasticFoot
{
public:
  /// @p contact_radius R [m], which defines the moment ratio.
  ElasticFoot(std::shared_ptr<const fem::Foot> foot, double contact_radius);

  double radius() const { return contact_radius; }

  /// Radii of the rings [m]; empty: one ring of its own radius for each load.
  const std::vector<double> &ring_radii() const { return radii; }
  /// Highest harmonic of its loads.
  unsigned int n_harmonics() const { return highest; }
  void set_rings(std::vector<double> new_radii, unsigned int n_harmonics);
  bool has_rings() const { return placed; }
  /// Goes back to before set_rings(): loads are to be gathered on other rings.
  void reset_rings();
  /// The same foot with a body of its own, which another thread may ask, on a path that goes on from here.
  std::shared_ptr<ElasticFoot> clone() const;

  /// The contact that carries @p demand at @p slip, on the rings of ring_radii(), looked for near @p before,
  /// or near the last one where that is nothing; Newton's steps go to @p progress. Throws
  /// fem::ContactFailure.
  fem::ContactState solve(fem::ContactDemand demand, const ring::Slip &slip = {},
                          Progress &progress = silent_progress(), const fem::ContactState *before = nullptr);

  /// Contacts start from what those of @p similar let expect, the foot of a study that differs little, and
  /// count with them.
  void predict_from_similar(const ElasticFoot &similar);

  /// Contacts solved so far by this foot, its twins and those that start like them.
  std::size_t n_contacts() const { return *n_solved; }

  /// solve() that remembers the last contact it has found: what is asked for at rest is asked for often.
  fem::ContactState solve_at_rest(const fem::ContactDemand &demand, const ring::Orientation &marks,
                                  Progress &progress);

  /// The load of @p state, a contact of this foot, on the rings of ring_radii().
  fem::ContactLoad project_onto_rings(const fem::ContactState &state) const
  {
    return foot->project_onto_rings(state, radii, highest);
  }

  const fem::Foot &body() const { return *foot; }

private:
  std::shared_ptr<const fem::Foot> foot;
  double contact_radius;
  std::vector<double> radii;
  unsigned int highest;
  bool placed = false; ///< whether set_rings() has been called
  ContactPath path;
  std::optional<fem::ContactState> at_rest; ///< of solve_at_rest()
  std::shared_ptr<std::atomic<std::size_t>> n_solved = std::make_shared<std::atomic<std::size_t>>(0);
};

/// @p n_rings Chebyshev points of the band from @p inner to @p outer [m], ascending.
std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings);

} // namespace stemware::pipeline
