#include "fem/pipeline/coupling/elastic_foot.h"

#include <utility>

namespace stemware::pipeline
{

ElasticFoot::ElasticFoot(std::shared_ptr<FootContact> foot, double contact_radius)
    : foot(std::move(foot))
    , contact_radius(contact_radius)
{
}

ring::RingStack ElasticFoot::load(double normal_force, const Eigen::Vector2d &moment) const
{
  pressed = foot->solve({ normal_force, moment.x(), moment.y() }, spin_per_speed, {}).load;
  ++n_solved;
  return ring::RingStack(pressed.a, pressed.b, pressed.ring_radius);
}

} // namespace stemware::pipeline
