#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/support/progress.h"
#include "ring_model/load_model.h"

#include <cstddef>
#include <memory>

namespace stemware::pipeline
{

/// The elastic foot of a study as the ring sees it: resultants and slip in, rings of load out. Each load is a
/// contact solution. Not for several threads at a time.
class ElasticFoot : public ring::LoadModel
{
public:
  /// @p contact_radius R [m], which defines the moment ratio.
  ElasticFoot(std::shared_ptr<fem::Foot> foot, double contact_radius);

  /// Throws fem::ContactFailure.
  ring::RingStack rings(double normal_force, const Eigen::Vector2d &moment,
                        const ring::Slip &slip = {}) const override;
  double radius() const override { return contact_radius; }
  double lift_off_ratio() const override { return 1; } // the contact itself knows; ContactState says
  double accuracy() const override { return 1e-11; }   // contact resultants are good to 1e-10 or better
  bool is_costly() const override { return true; }

  /// The contact with the resultants N and M_N at @p slip, from the solution before; Newton's steps go to @p
  /// progress. Throws fem::ContactFailure.
  fem::ContactState solve(double normal_force, const Eigen::Vector2d &moment, const ring::Slip &slip = {},
                          Progress &progress = silent_progress()) const;

  /// Contact solutions so far.
  std::size_t n_solutions() const { return n_solved; }

  fem::Foot &body() const { return *foot; }

private:
  const std::shared_ptr<fem::Foot> foot;
  const double contact_radius;
  mutable std::size_t n_solved = 0;
};

/// A contact's load as rings: the only place where the one becomes the other.
ring::RingStack ring_stack(const fem::LoadHarmonics &load);

} // namespace stemware::pipeline
