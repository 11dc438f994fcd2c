#include "ring_model/truncated_model.h"

#include "ring_model/require.h"

#include <utility>

namespace stemware::ring
{
TruncatedModel::TruncatedModel(std::shared_ptr<const LoadModel> model, unsigned int n_max)
    : model(std::move(model))
    , n_max(n_max)
{
  require(this->model != nullptr, "the truncated load model has no model to truncate");
  require(n_max >= 1, "a load cut off after ", n_max,
          " harmonics carries no moment; keep the first at least");
}

RingStack TruncatedModel::rings(double normal_force, const Eigen::Vector2d &moment, const Slip &slip) const
{
  return model->rings(normal_force, moment, slip).truncated(n_max);
}
} // namespace stemware::ring
