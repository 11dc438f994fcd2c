#pragma once

#include "ring_model/load_model.h"

#include <memory>

namespace stemware::ring
{
/**
 * The loads of another model without their harmonics above n_max: what a ring would do that feels only these.
 *
 * The normal force and M_N lie in the harmonics 0 and 1, which stay, so a truncated load carries what it is
 * asked to carry. Its friction differs, and in a SelfConsistentRing that acts back on M_N and so on the
 * harmonics that are kept. With n_max = 1 and a thin ring it is the formal first harmonic.
 */
class TruncatedModel : public LoadModel
{
public:
  /// @throws std::invalid_argument without a model, or if @p n_max is 0: that load would carry no moment.
  TruncatedModel(std::shared_ptr<const LoadModel> model, unsigned int n_max);

  /// Throws as the model does: a truncated load tips where the whole one tips.
  RingStack rings(double normal_force, const Eigen::Vector2d &moment, const Slip &slip = {}) const override;
  double radius() const override { return model->radius(); }
  double lift_off_ratio() const override { return model->lift_off_ratio(); }
  double moment_ratio_limit() const override { return model->moment_ratio_limit(); }
  double accuracy() const override { return model->accuracy(); }
  bool is_costly() const override { return model->is_costly(); }
  bool follows_moment() const override { return model->follows_moment(); }

private:
  std::shared_ptr<const LoadModel> model;
  unsigned int n_max;
};
} // namespace stemware::ring
