#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/support/progress.h"
#include "ring_model/ring_stack.h"
#include "ring_model/slip.h"

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
  ElasticFoot(std::shared_ptr<fem::Foot> foot, double contact_radius);

  double radius() const { return contact_radius; }

  /// Radii of the rings [m]; empty: one ring of its own radius for each load.
  const std::vector<double> &ring_radii() const { return radii; }
  /// Highest harmonic of its loads.
  unsigned int n_harmonics() const { return highest; }
  void set_rings(std::vector<double> new_radii, unsigned int n_harmonics);
  bool has_rings() const { return placed; }
  /// This foot before set_rings(): the same body, whose loads are to be gathered on other rings.
  ElasticFoot without_rings() const;

  /// The contact that carries @p demand at @p slip, on the rings of ring_radii(), from the solution before;
  /// Newton's steps go to @p progress. Throws fem::ContactFailure.
  fem::ContactState solve(fem::ContactDemand demand, const ring::Slip &slip = {},
                          Progress &progress = silent_progress()) const;

  /// The next contact starts from @p state, one of this foot's.
  void resume(const fem::ContactState &state) const { foot->resume(state); }

  /// Contacts start from what those of @p similar let expect, the foot of a study that differs little.
  void start_like(const ElasticFoot &similar) const { foot->start_like(*similar.foot); }

  /// solve() that remembers the last contact it has found: what is asked for at rest is asked for often.
  const fem::ContactState &solve_at_rest(const fem::ContactDemand &demand, const ring::Orientation &marks,
                                         Progress &progress);

  /// The load of @p state, a contact of this foot, on the rings of ring_radii().
  fem::LoadHarmonics gather(const fem::ContactState &state) const
  {
    return foot->gather(state, radii, highest);
  }

  /// Contact solutions so far.
  std::size_t n_solutions() const { return n_solved; }

  fem::Foot &body() const { return *foot; }

private:
  const std::shared_ptr<fem::Foot> foot;
  const double contact_radius;
  std::vector<double> radii;
  unsigned int highest;
  bool placed = false; ///< whether set_rings() has been called
  mutable std::size_t n_solved = 0;
  std::optional<fem::ContactState> at_rest; ///< of solve_at_rest()
  fem::ContactDemand demand_at_rest;
};

/// A contact's load as rings: the only place where the one becomes the other. One ring is turned to the
/// direction of M_N, which it then carries.
ring::RingStack ring_stack(const fem::LoadHarmonics &load);

/// By how much one ring has to be turned counter-clockwise for its first harmonic to have the direction of
/// M_N [rad]: 0 by symmetry but for friction that deforms the foot.
double ring_rotation(const fem::LoadHarmonics &load);

/// @p n_rings Chebyshev points of the band from @p inner to @p outer [m], ascending.
std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings);

} // namespace stemware::pipeline
