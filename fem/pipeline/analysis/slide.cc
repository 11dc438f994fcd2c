#include "fem/pipeline/analysis/slide.h"

#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/variants/solve.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace stemware::pipeline
{

namespace
{

constexpr double largest_slip_ratio = 64; ///< to which the contact of a glass is followed

/// Friction, and the moment ratio with which it tilts the pressure.
struct TiltingFriction
{
  ring::Wrench wrench;
  double moment_ratio;
};

/// Friction of a body at a speed [m/s] and a spin [rad/s].
using FrictionLaw = std::function<TiltingFriction(double speed, double omega)>;

/// Shares of the weight instead of the contact: kernels alone.
FrictionLaw friction_of_body(const ring::FreeSlider &slider)
{
  return [slider](double speed, double omega)
  {
    const ring::Wrench wrench = ring::sliding_friction(slider, speed, omega);
    // p ~ 1 + r (alpha cos + beta sin) with N <r^2> / 2 |(alpha, beta)| = h |T|.
    const double moment_ratio = 2 * slider.centre_of_mass_height * slider.body.outer_radius() *
                                std::hypot(wrench.force_x, wrench.force_y) /
                                (slider.mass * slider.gravity * slider.body.mean_square_radius());
    return TiltingFriction{ wrench, moment_ratio };
  };
}

/// The load depends on the ratio of spin and speed: it is asked for at the orbit's speed.
FrictionLaw friction_of_load(const BalancedLoad &load, const Study &study)
{
  const ring::Motion &motion = study.motion.orbit;
  return [load = load.shared_from_this(), mu = motion.friction_coefficient, reference = motion.orbit_speed,
          radius = study.glass.profile.contact_radius](double speed, double omega)
  {
    const LeaningLoad at_spin = load->at(omega / speed * reference);
    return TiltingFriction{ ring::coulomb_wrench(mu, at_spin, omega, speed), at_spin.moment_ratio(radius) };
  };
}

/// The study of a glass that no hand leads: the moment of friction about the centre of mass is all that the
/// pressure has to balance (closure full, with the force of the hand at the centre of mass, where it has no
/// moment).
Study without_hand(Study study)
{
  study.motion.closure = ring::Closure::full;
  study.motion.orbit.force_offset = 0;
  study.motion.orbit.orbit_acceleration = 0;
  study.motion.grip_torque = 0;
  return study;
}

void require_standing(const SlideStudy &slide, double speed, double omega, const ring::Wrench &friction)
{
  const double moment = slide.centre_of_mass_height * std::hypot(friction.force_x, friction.force_y);
  const double most = slide.inertia.mass * slide.gravity * slide.inertia.outer_radius;
  if (!(moment < most))
    throw std::runtime_error(fmt::format(
      FMT_STRING("The {} tips over: at {} m/s and {} rad/s the friction's moment about the centre of mass is "
                 "{} N m, but its weight holds {}; lower Motion/Centre of mass height or the friction."),
      to_string(slide.question.body), to_short_text(speed), to_short_text(omega), to_short_text(moment),
      to_short_text(most)));
}

/// Fills in the path, point by point.
void follow(const FrictionLaw &law, const ring::SlidingPath &path, SlideStudy &slide)
{
  const ring::SlidingInertia &inertia = slide.inertia;
  slide.final_slip_ratio = path.final_slip_ratio;
  for (std::size_t i = 0; i < path.states.size(); ++i)
  {
    const ring::SlidingState &state = path.states[i];
    // At the stop only the ratio is left of the two speeds.
    const ring::SlidingState &moving = state.speed > 0 || state.omega != 0 ? state : path.states[i - 1];
    const auto [friction, moment_ratio] = law(moving.speed, moving.omega);
    require_standing(slide, moving.speed, moving.omega, friction);
    slide.points.push_back(
      { state, moving.omega * inertia.outer_radius / moving.speed, friction, friction.force_y / inertia.mass,
        (inertia.mass * state.speed * state.speed + inertia.yaw_inertia * state.omega * state.omega) / 2,
        moment_ratio });
  }
  slide.points.back().slip_ratio = path.final_slip_ratio;
  const double energy = slide.start().kinetic_energy;
  for (const SlidePoint &point : slide.points)
    slide.energy_error = std::max(
      slide.energy_error, std::abs(point.kinetic_energy + point.state.friction_loss - energy) / energy);
}

/// SlideStudy::mesh_change. @p foot and @p load are those of @p study.
std::optional<double> change_on_coarser_mesh(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                             const BalancedLoad &load, double start, double end,
                                             const Executor &executor)
{
  if (!study.load.is_from_contact() || !abilities(study.contact.body).is_of_revolution)
    return std::nullopt;
  Variant coarse = { "mesh", "", study };
  coarse.study.contact.fineness /= 2;
  coarse.study.contact.harmonics = std::max(study.contact.harmonics / 2, 1u);
  const auto change = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &coarse_foot)
  {
    const ring::Motion &motion = study.motion.orbit;
    const double radius = study.glass.profile.contact_radius,
                 most = motion.friction_at_rest() * motion.normal_force();
    const SharedLoad coarse_load = find_load(variant.study, coarse_foot);
    const FrictionLaw own = friction_of_load(load, study), other = friction_of_load(*coarse_load, study);
    double largest = 0;
    for (const double slip_ratio : { start, (start + end) / 2, end })
    {
      const double speed = motion.orbit_speed, omega = slip_ratio * speed / radius;
      const ring::Wrench one = own(speed, omega).wrench, two = other(speed, omega).wrench;
      largest = std::max({ largest, std::abs(two.force_x - one.force_x) / most,
                           std::abs(two.force_y - one.force_y) / most,
                           std::abs(two.torque - one.torque) / (most * radius) });
    }
    return largest;
  };
  return solve(std::vector<Variant>{ coarse }, foot, change, executor).front().value();
}

void slide_glass(const Study &given, SlideStudy &slide, Progress &progress)
{
  const Study study = without_hand(given);
  const ring::Motion &motion = study.motion.orbit;
  slide.inertia = { motion.mass, motion.yaw_inertia, study.glass.profile.contact_radius };
  slide.centre_of_mass_height = motion.centre_of_mass_height;
  fem::ComplianceCache cache;
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, cache, progress);
  const SharedLoad load = find_load(study, foot, progress);
  const double start = slide.question.spin * slide.inertia.outer_radius / slide.question.speed;
  const FrictionLaw exact = friction_of_load(*load, study);
  const auto exact_wrench = [&](double speed, double omega)
  {
    if (std::abs(omega) * slide.inertia.outer_radius > largest_slip_ratio * speed)
      throw std::runtime_error("The spin of the glass outlasts its sliding, through which its contact is not "
                               "followed; give a Motion/Yaw inertia of less than about 2 m R^2, or slide a "
                               "ring.");
    return exact(speed, omega).wrench;
  };
  constexpr unsigned int n_intervals = 20;
  const double end = start == 0 ? 0 : ring::final_slip_ratio(slide.inertia, exact_wrench, start, n_intervals);
  progress.stage_done("final slip ratio");
  const double unit = motion.orbit_speed / slide.inertia.outer_radius, margin = 1e-3;
  const auto [least, most] = std::minmax(start, end);
  const SharedLoad on_the_way =
    load->interpolated(unit * (least - margin * std::abs(least)), unit * (most + margin * std::abs(most)));
  if (const auto statistics = on_the_way->statistics())
    slide.load_error = statistics->interpolation_error.value_or(0);
  const FrictionLaw law = friction_of_load(*on_the_way, study);
  const auto wrench = [&](double speed, double omega) { return law(speed, omega).wrench; };
  ring::SlidingPath path =
    ring::slide_to_stop(slide.inertia, wrench, slide.question.speed, slide.question.spin, 1e-10);
  path.final_slip_ratio = end;
  follow(law, path, slide);
  if (foot)
    slide.mesh_change = change_on_coarser_mesh(study, foot, *load, start, end, cache);
}

void slide_body(const Study &study, SlideStudy &slide)
{
  const ring::Motion &motion = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  ring::FreeSlider slider{ slide.question.body == SlidingBodyKind::ring
                             ? ring::SlidingBody::ring(radius)
                             : ring::SlidingBody::annulus(slide.question.inner_radius, radius),
                           motion.mass, motion.yaw_inertia, motion.friction_coefficient, motion.gravity };
  if (!slide.inertia_is_given)
    slider.yaw_inertia = slider.mass * slider.body.mean_square_radius();
  if (slide.height_is_given)
    slider.centre_of_mass_height = motion.centre_of_mass_height;
  slide.inertia = { slider.mass, slider.yaw_inertia, slider.body.outer_radius() };
  slide.centre_of_mass_height = slider.centre_of_mass_height;
  follow(friction_of_body(slider), ring::slide_to_stop(slider, slide.question.speed, slide.question.spin),
         slide);
}

} // namespace

std::string to_string(SlidingBodyKind kind)
{
  static constexpr const char *names[] = { "glass", "ring", "annulus", "disc" };
  return names[static_cast<std::size_t>(kind)];
}

double SlideStudy::largest_moment_ratio() const
{
  double largest = 0;
  for (const SlidePoint &point : points)
    largest = std::max(largest, point.moment_ratio);
  return largest;
}

void check_slide(const Study &study, const SlideQuestion &question)
{
  const double radius = study.glass.profile.contact_radius;
  if (question.body == SlidingBodyKind::annulus)
    require(0 < question.inner_radius && question.inner_radius < radius,
            fmt::format(FMT_STRING("--inner-radius = {} m is not allowed for an annulus of the outer radius "
                                   "Glass/Contact radius = {} m; give a length between 0 and that."),
                        to_text(question.inner_radius), to_text(radius)));
  else
    require(question.inner_radius == 0,
            "--inner-radius belongs to --body annulus; set that, or leave --inner-radius away.");
  require(study.motion.orbit.has_constant_friction(),
          "A slide knows friction with one coefficient; set Motion/Friction law = Coulomb.");
  if (question.body != SlidingBodyKind::glass)
    return;
  require_flat(study, "slide");
  require(study.load.source != LoadSource::file && !study.load.is_static(),
          "A sliding glass balances the moment of its friction, but Load/Moment ratio or Load/File give "
          "another; leave them away.");
  without_hand(study).required_resultants(); // refuses a glass that would tip
}

SlideStudy study_slide(const Study &study, const SlideQuestion &question, Progress &progress)
{
  check_slide(study, question);
  SlideStudy slide;
  slide.question = question;
  slide.friction_coefficient = study.motion.orbit.friction_coefficient;
  slide.gravity = study.motion.orbit.gravity;
  slide.inertia_is_given = study.given_entries.count("Motion/Yaw inertia") > 0;
  slide.height_is_given = study.given_entries.count("Motion/Centre of mass height") > 0;
  if (question.body == SlidingBodyKind::glass)
    slide_glass(study, slide, progress);
  else
    slide_body(study, slide);
  progress.stage_done("slide");
  return slide;
}

std::vector<std::string> idle_in_slide(const Study &study, SlidingBodyKind body)
{
  static const std::set<std::string> of_every_body = {
    "Motion/Mass",    "Motion/Yaw inertia",  "Motion/Centre of mass height", "Motion/Friction coefficient",
    "Motion/Gravity", "Glass/Contact radius"
  };
  std::vector<std::string> idle;
  for (const auto &[entry, text] : study.given_entries)
  {
    const bool is_of_contact = entry.rfind("Motion/", 0) != 0 || entry == "Motion/Tilt";
    if (of_every_body.count(entry) == 0 && !(body == SlidingBodyKind::glass && is_of_contact))
      idle.push_back(entry);
  }
  return idle;
}

} // namespace stemware::pipeline
