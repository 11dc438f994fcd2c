#include "fem/pipeline/analysis/compared_loads.h"

#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/first_harmonic_ring.h"
#include "ring_model/truncated_model.h"
#include "ring_model/unilateral_foundation.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stemware::pipeline
{

namespace
{

/// Truncations that are compared: 1, 2, 3 and all.
std::vector<unsigned int> compared_orders(unsigned int n_all)
{
  std::vector<unsigned int> orders;
  for (const unsigned int n : { 1u, 2u, 3u })
    if (n < n_all)
      orders.push_back(n);
  orders.push_back(n_all);
  return orders;
}

/// Share of the ring on which cos(theta - beta) > c.
double loaded_share(double edge)
{
  return edge <= -1 ? 1 : std::acos(edge) / boost::math::constants::pi<double>();
}

/// Balances of a load model with some of its harmonics.
std::shared_ptr<BalancedStates> balances(const Study &study, ring::Closure closure,
                                         const std::shared_ptr<const ring::LoadModel> &model,
                                         unsigned int n_harmonics,
                                         const std::function<void(double)> &before = {})
{
  const ring::Motion &orbit = study.motion.orbit;
  return std::make_shared<BalancedStates>(
    ring::SelfConsistentRing(closure, orbit, std::make_shared<ring::TruncatedModel>(model, n_harmonics)),
    orbit.orbit_speed / model->radius(), before);
}

/// Harmonics of the loads of a foot, which are the same for all: those of its weight alone are counted.
unsigned int n_harmonics_of(const Study &study, FootContact &foot)
{
  const fem::LoadHarmonics load = foot.solve({ study.motion.orbit.normal_force(), 0, 0 }, 0, {}).load;
  return static_cast<unsigned int>(load.a.size()) - 1;
}

} // namespace

LoadKind first_harmonic_kind(const Study &study)
{
  return { "first harmonic",
           { 1 },
           [&study](ring::Closure closure, unsigned int) -> ComparedLoad
           {
             const ring::FirstHarmonicRing ring(closure, study.motion.orbit,
                                                study.glass.profile.contact_radius);
             return { [ring](double omega) { return ring.load(omega); }, {} };
           } };
}

LoadKind rigid_ring_kind(const Study &study, double exponent)
{
  const auto ring =
    std::make_shared<ring::UnilateralFoundation>(study.glass.profile.contact_radius, exponent);
  const unsigned int n_all = static_cast<unsigned int>(ring->shape(1.5).size()) - 1;
  return { exponent == 1 ? "rigid flat rim" : "rigid round rim", compared_orders(n_all),
           [=, &study](ring::Closure closure, unsigned int n_harmonics) -> ComparedLoad
           {
             const auto states = balances(study, closure, ring, n_harmonics);
             return { [states](double omega) { return states->at(omega).load; }, [=](double omega)
                      { return loaded_share(ring->edge(states->at(omega).moment_ratio)); } };
           } };
}

LoadKind resting_foot_kind(const Study &study, const std::shared_ptr<FootContact> &foot)
{
  return {
    "elastic foot at rest", compared_orders(n_harmonics_of(study, *foot)),
    [&study, foot](ring::Closure closure, unsigned int n_harmonics) -> ComparedLoad
    {
      Study with_closure = study;
      with_closure.motion.closure = closure;
      const fem::LoadHarmonics load = foot->solve(with_closure.required_resultants(), 0, {}).load;
      const ring::AngularLoad kept =
        ring::AngularLoad(load.a, load.b, load.ring_radius).truncated(n_harmonics);
      return { [kept](double) { return kept; }, [share = load.contact_fraction](double) { return share; } };
    }
  };
}

LoadKind balanced_foot_kind(const Study &study, const std::shared_ptr<FootContact> &contact)
{
  const auto foot = std::make_shared<ElasticFoot>(contact, study.glass.profile.contact_radius);
  return { balanced_foot, compared_orders(n_harmonics_of(study, *contact)),
           [&study, foot](ring::Closure closure, unsigned int n_harmonics) -> ComparedLoad
           {
             const ring::Motion &orbit = study.motion.orbit;
             const auto before = [foot, speed = orbit.orbit_speed](double omega)
             { foot->spin_per_speed = omega / speed; };
             const auto states = balances(study, closure, foot, n_harmonics, before);
             return { [states](double omega) { return states->at(omega).load; },
                      [=, weight = orbit.normal_force()](double omega)
                      {
                        const Eigen::Vector2d moment = states->at(omega).load.moment();
                        before(omega);
                        foot->load(weight, moment);
                        return foot->contact().contact_fraction;
                      } };
           } };
}

} // namespace stemware::pipeline
