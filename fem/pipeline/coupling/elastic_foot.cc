#include "fem/pipeline/coupling/elastic_foot.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

ElasticFoot::ElasticFoot(std::shared_ptr<fem::Foot> foot_given, double contact_radius)
    : foot(std::move(foot_given))
    , contact_radius(contact_radius)
    , highest(foot->n_resolved_harmonics())
{
}

void ElasticFoot::set_rings(std::vector<double> new_radii, unsigned int n_harmonics)
{
  radii = std::move(new_radii);
  placed = true;
  highest = std::min(n_harmonics, foot->n_resolved_harmonics());
}

ElasticFoot ElasticFoot::without_rings() const
{
  ElasticFoot same = *this;
  same.set_rings({}, foot->n_resolved_harmonics());
  same.placed = false;
  return same;
}

fem::ContactState ElasticFoot::solve(fem::ContactDemand demand, const ring::Slip &slip,
                                     Progress &progress) const
{
  ++n_solved;
  if (!demand.has_friction()) // else the demand knows the rings that its friction is of
    demand.ring_radii = radii;
  demand.n_harmonics = highest;
  return foot->solve(demand, { slip.spin_per_speed, { slip.orientation.glass, slip.orientation.table } },
                     [&progress](const fem::ContactIteration &step)
                     {
                       progress.iteration({ step.number, step.n_loaded, step.n_changed, step.residual,
                                            step.step_length, step.linear_iterations });
                     });
}

const fem::ContactState &ElasticFoot::solve_at_rest(const fem::ContactDemand &demand,
                                                    const ring::Orientation &marks, Progress &progress)
{
  const auto is_known = [&]
  {
    const fem::FootOrientation &known = at_rest->slip.orientation;
    return demand.normal_force == demand_at_rest.normal_force && demand.moment_x == demand_at_rest.moment_x &&
           demand.moment_y == demand_at_rest.moment_y && demand.tilt_moment == demand_at_rest.tilt_moment &&
           known.glass == marks.glass && known.table == marks.table;
  };
  if (at_rest && is_known())
  {
    at_rest->load = gather(*at_rest); // the rings may be others by now
    return *at_rest;
  }
  at_rest = solve(demand, { 0, marks }, progress);
  demand_at_rest = demand;
  return *at_rest;
}

ring::RingStack ring_stack(const fem::LoadHarmonics &load)
{
  std::vector<ring::RingStack::Ring> rings;
  for (std::size_t j = 0; j < load.radii.size(); ++j)
    rings.push_back({ load.radii[j], load.a[j], load.b[j] });
  ring::RingStack stack(std::move(rings));
  const double moment = std::hypot(load.moment_x, load.moment_y);
  if (load.n_rings() > 1 || load.n_harmonics() == 0 || moment < 1e-10 * load.normal_force * load.mean_radius)
    return stack;
  return stack.rotated(ring_rotation(load));
}

double ring_rotation(const fem::LoadHarmonics &load)
{
  return std::remainder(std::atan2(load.moment_x, -load.moment_y) - std::atan2(load.b[0][1], load.a[0][1]),
                        boost::math::double_constants::two_pi);
}

std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings)
{
  std::vector<double> radii;
  for (unsigned int j = 0; j < n_rings; ++j)
    radii.push_back((inner + outer) / 2 -
                    (outer - inner) / 2 *
                      std::cos(boost::math::double_constants::pi * (2 * j + 1) / (2. * n_rings)));
  return radii;
}

} // namespace stemware::pipeline
