#include "fem/pipeline/coupled_load.h"

#include "ring_model/self_consistent_ring.h"

#include <map>

namespace stemware::pipeline
{

namespace
{

/// The finite-element foot as the ring sees it: resultants in, load out.
class ElasticFoot : public ring::LoadModel
{
public:
  ElasticFoot(std::shared_ptr<FootContact> foot, double contact_radius)
      : foot(std::move(foot))
      , contact_radius(contact_radius)
  {
  }

  ring::AngularLoad load(double normal_force, const Eigen::Vector2d &moment) const override
  {
    const fem::LoadHarmonics pressed =
      foot->solve({ normal_force, moment.x(), moment.y() }, spin_per_speed, {}).load;
    return ring::AngularLoad(pressed.a, pressed.b, pressed.ring_radius);
  }
  double radius() const override { return contact_radius; }
  double lift_off_ratio() const override { return 1; } // not used here: the contact itself knows

  double spin_per_speed = 0; ///< omega / v, the direction of the friction that deforms the foot [1/m]

private:
  const std::shared_ptr<FootContact> foot;
  const double contact_radius;
};

/// Self-consistent loads, each spin solved once.
class CoupledStates
{
public:
  CoupledStates(const Study &study, const std::shared_ptr<FootContact> &foot,
                const ring::AngularLoad &at_rest, std::function<void(std::size_t)> progress)
      : model(std::make_shared<ElasticFoot>(foot, study.glass.profile.contact_radius))
      , glass(study.motion.closure, study.motion.orbit, model)
      , speed(study.motion.orbit.orbit_speed)
      , progress(std::move(progress))
      , states({ { 0., at_rest } })
  {
  }

  const ring::AngularLoad &at(double omega)
  {
    const auto known = states.find(omega);
    if (known != states.end())
      return known->second;
    model->spin_per_speed = omega / speed;
    const ring::AngularLoad &load = states.emplace(omega, glass.at(omega).load).first->second;
    progress(states.size());
    return load;
  }

private:
  const std::shared_ptr<ElasticFoot> model;
  const ring::SelfConsistentRing glass;
  const double speed;
  const std::function<void(std::size_t)> progress;
  std::map<double, ring::AngularLoad> states;
};

} // namespace

RingLoad coupled_contact_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                              const fem::LoadHarmonics &at_rest,
                              const std::function<void(std::size_t)> &progress)
{
  RingLoad load = frozen_contact_load(at_rest, study.glass.profile.contact_radius);
  const auto states = std::make_shared<CoupledStates>(study, foot, load.at_rest, progress);
  load.at_spin = [states](double omega) { return states->at(omega); };
  return load;
}

} // namespace stemware::pipeline
