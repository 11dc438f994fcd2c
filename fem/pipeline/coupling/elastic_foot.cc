#include "fem/pipeline/coupling/elastic_foot.h"

#include <utility>
#include <vector>

namespace stemware::pipeline
{

ElasticFoot::ElasticFoot(std::shared_ptr<fem::Foot> foot_given, double contact_radius)
    : foot(std::move(foot_given))
    , contact_radius(contact_radius)
{
}

ring::RingStack ElasticFoot::rings(double normal_force, const Eigen::Vector2d &moment,
                                   const ring::Slip &slip) const
{
  return ring_stack(solve(normal_force, moment, slip).load);
}

fem::ContactState ElasticFoot::solve(double normal_force, const Eigen::Vector2d &moment,
                                     const ring::Slip &slip, Progress &progress) const
{
  ++n_solved;
  return foot->solve({ normal_force, moment.x(), moment.y() },
                     { slip.spin_per_speed, { slip.orientation.glass, slip.orientation.table } },
                     [&progress](const fem::ContactIteration &step)
                     {
                       progress.iteration({ step.number, step.n_loaded, step.n_changed, step.residual,
                                            step.step_length, step.linear_iterations });
                     });
}

ring::RingStack ring_stack(const fem::LoadHarmonics &load)
{
  std::vector<ring::RingStack::Ring> rings;
  for (std::size_t j = 0; j < load.radii.size(); ++j)
    rings.push_back({ load.radii[j], load.a[j], load.b[j] });
  return ring::RingStack(std::move(rings));
}

} // namespace stemware::pipeline
