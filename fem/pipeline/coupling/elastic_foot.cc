#include "fem/pipeline/coupling/elastic_foot.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

ElasticFoot::ElasticFoot(std::shared_ptr<const fem::Foot> foot_given, FootSpecification specification)
    : foot(std::move(foot_given))
    , made_from(std::move(specification))
    , highest(foot->n_resolved_harmonics())
{
}

void ElasticFoot::set_rings(std::vector<double> new_radii, unsigned int n_harmonics)
{
  radii = std::move(new_radii);
  placed = true;
  highest = std::min(n_harmonics, foot->n_resolved_harmonics());
}

void ElasticFoot::reset_rings()
{
  set_rings({}, foot->n_resolved_harmonics());
  placed = false;
}

std::shared_ptr<ElasticFoot> ElasticFoot::clone(Study study) const
{
  const auto twin = std::make_shared<ElasticFoot>(*this);
  twin->made_from.study = std::move(study);
  if (std::shared_ptr<const fem::Foot> body = foot->clone())
    twin->foot = std::move(body);
  return twin;
}

void ElasticFoot::predict_from_similar(const ElasticFoot &similar)
{
  path.predict_from_similar(similar.path, *foot, *similar.foot);
}

fem::ContactState ElasticFoot::solve(fem::ContactDemand demand, const ring::Slip &slip, Progress &progress,
                                     const fem::ContactState *before)
{
  if (!demand.has_friction()) // a demand with friction already has rings
    demand.ring_radii = radii;
  demand.n_harmonics = highest;
  const auto solve_from = [&](const fem::ContactGuess &guess)
  {
    return foot->solve(demand, slip, guess,
                       [&progress](const fem::ContactIteration &step) { progress.iteration(step); });
  };
  fem::ContactState state;
  try
  {
    state = solve_from(path.guess(demand, slip, before));
  }
  catch (const fem::ContactFailure &failure)
  {
    // Near tipping, the nearest stored solution may lie on the branch of balances beyond the limit point. A
    // second solve therefore starts from a stored solution closer to rest.
    if (failure.outcome != fem::ContactOutcome::tipping || foot->capabilities().is_collective)
      throw;
    const std::optional<fem::ContactStart> start = path.nearest_towards_rest(slip);
    if (!start)
      throw;
    state = solve_from({ nullptr, start });
  }
  path.append(state);
  return state;
}

fem::ContactState ElasticFoot::solve_at_rest(const fem::ContactDemand &demand, const ring::Orientation &marks,
                                             Progress &progress)
{
  const auto is_known = [&]
  {
    const fem::ContactDemand &known = at_rest->demand;
    const ring::Orientation &known_marks = at_rest->slip.orientation;
    return demand.normal_force == known.normal_force && demand.moment_x == known.moment_x &&
           demand.moment_y == known.moment_y && demand.tilt_moment == known.tilt_moment &&
           marks.glass == known_marks.glass && marks.table == known_marks.table;
  };
  if (at_rest && is_known())
    at_rest->load = project_onto_rings(*at_rest); // the rings may have changed since the last call
  else
    at_rest = solve(demand, { 0, marks }, progress);
  return *at_rest;
}

std::shared_ptr<ElasticFoot> study_foot(const FootSpecification &specification, const FootMaker &make_foot,
                                        Progress &progress, const ElasticFoot *similar)
{
  if (!specification.study.load.is_from_contact())
    return nullptr;
  auto foot = std::make_shared<ElasticFoot>(make_foot(specification, similar ? &similar->body() : nullptr),
                                            specification);
  if (similar)
    foot->predict_from_similar(*similar);
  progress.stage_done("mesh_and_stiffness");
  return foot;
}

std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings)
{
  std::vector<double> radii;
  for (unsigned int j = 0; j < n_rings; ++j)
    radii.push_back((inner + outer) / 2 -
                    (outer - inner) / 2 * std::cos(ring::pi * (2 * j + 1) / (2. * n_rings)));
  return radii;
}

} // namespace stemware::pipeline
