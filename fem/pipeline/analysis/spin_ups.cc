#include "fem/pipeline/analysis/spin_ups.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/variants/solve.h"
#include "ring_model/if_balanced.h"
#include "ring_model/load/lagrange.h"
#include "ring_model/spin/answer.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> key_of(const VectorXd &x)
{
  return { x.begin(), x.end() };
}

/// The spin to which the glass turns without a grip, or at which it tips; its fall is a failure of balance
/// for @p may_fall = false.
double last_spin_of(const ring::LoadAtSpin &load, const Study &study, bool may_fall)
{
  ring::Question free = spin_question(study);
  free.grip_torque = 0;
  free.with_minima = false;
  const ring::Answer found = ring::answer(load, free).value();
  if (found.fall && !may_fall)
    throw ring::NoBalance(found.reason);
  return found.last_spin().value();
}

VectorXd torques_of(const ring::LoadAtSpin &load, const ring::Motion &motion, double last)
{
  VectorXd torques(TorqueBySpin::n_points);
  for (Index i = 0; i < torques.size(); ++i)
    torques(i) = ring::yaw_torque(load, motion, last * TorqueBySpin::shares()(i));
  return torques;
}

double radius_of(const Study &study)
{
  return study.load.from_file ? study.load.from_file->radius() : study.glass.profile.contact_radius;
}

/// Torque mu N R, the unit of torques [N m].
double unit_torque(const Study &study)
{
  const ring::Motion &motion = study.motion.orbit;
  return motion.friction_at_rest() * motion.normal_force() * radius_of(study);
}

/// The next Leja point among the shares of the last spin: the one with the largest product of the distances
/// to @p places.
Index next_point(const VectorXd &places)
{
  const VectorXd &shares = TorqueBySpin::shares();
  if (places.size() < 2)
    return places.size() == 0 ? 0 : shares.size() - 1;
  VectorXd products = VectorXd::Ones(shares.size());
  for (const double place : places)
    products.array() *= (shares.array() - place).abs();
  Index best = 0;
  products.maxCoeff(&best);
  return best;
}

} // namespace

void ScatteredPolynomial::add(const VectorXd &place, const VectorXd &value, bool is_centre)
{
  constexpr double too_near = 3e-3;
  constexpr std::size_t most = 12;
  const VectorXd centre = is_centre || points.empty() ? place : points.front().place;
  const auto distance = [&](const Point &point) { return (point.place - centre).norm(); };
  points.insert(is_centre ? points.begin() : points.end(), { place, value });
  points.erase(std::remove_if(points.begin() + 1, points.end(),
                              [&](const Point &point) { return distance(point) < too_near; }),
               points.end());
  if (points.size() > most)
    points.erase(std::max_element(points.begin() + 1, points.end(),
                                  [&](const Point &one, const Point &other)
                                  { return distance(one) < distance(other); }));
  const auto n = static_cast<Index>(points.size()) - 1;
  if (n == 0)
  {
    coefficients.resize(0, 0);
    return;
  }
  reach = 0;
  for (const Point &point : points)
    reach = std::max(reach, distance(point));
  MatrixXd rows(n, 0), values(value.size(), n);
  for (Index i = 0; i < n; ++i)
  {
    const Point &point = points[static_cast<std::size_t>(i + 1)];
    const VectorXd row = monomials(point.place - centre);
    rows.conservativeResize(n, row.size());
    rows.row(i) = row.transpose();
    values.col(i) = point.value - points.front().value;
  }
  coefficients = rows.completeOrthogonalDecomposition().solve(values.transpose()).transpose();
}

VectorXd ScatteredPolynomial::monomials(const VectorXd &from_centre) const
{
  constexpr double shrinkage = 0.03; // from degree to degree
  const int highest = from_centre.size() <= 2 ? 6 : 3;
  std::vector<double> found;
  const std::function<void(Index, int, double)> multiply = [&](Index first, int degree, double product)
  {
    for (Index j = first; degree < highest && j < from_centre.size(); ++j)
    {
      const double next = product * shrinkage * from_centre(j) / reach;
      found.push_back(next);
      multiply(j, degree + 1, next);
    }
  };
  multiply(0, 0, 1);
  return Eigen::Map<const VectorXd>(found.data(), static_cast<Index>(found.size()));
}

VectorXd ScatteredPolynomial::at(const VectorXd &place) const
{
  const Point &centre = points.front();
  if (coefficients.size() == 0)
    return centre.value;
  return centre.value + coefficients * monomials(place - centre.place);
}

SpinUps::FirstHarmonic SpinUps::first_harmonic(const Study &now) const
{
  const SharedLoad load = first_harmonic_load(now, now.motion.closure);
  const ring::Motion &motion = now.motion.orbit;
  const double last = stretch * last_spin_of(*load, now, false);
  return { last, unit_torque(now), torques_of(*load, motion, last) };
}

VectorXd SpinUps::place_of(const VectorXd &x) const
{
  std::vector<double> place;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    if (parameters[j].acts_on_load())
      place.push_back(x(static_cast<Index>(j)));
  return Eigen::Map<const VectorXd>(place.data(), static_cast<Index>(place.size()));
}

SharedLoad SpinUps::load_of(const Study &now)
{
  const bool on_same_foot = foot && std::all_of(parameters.begin(), parameters.end(),
                                                [](const FitParameter &parameter)
                                                { return parameter.path.rfind("Motion/", 0) == 0; });
  Variant variant = { "", "", now };
  variant.on_same_foot = on_same_foot;
  foot = foot_of(variant, foot, executor);
  return find_load(now, foot);
}

TorqueBySpin SpinUps::solved_torque(const Study &now)
{
  const SharedLoad load = load_of(now);
  // The steps of an integrator reach a little beyond the last spin, and beyond rest if there is no torque.
  const double spin = 1.001 * last_spin_of(*load, now, true),
               last = spin != 0 ? spin : 1e-6 * load->spin_scale(now.motion.orbit);
  const ring::SharedLoad curve = ring::interpolated(load, std::min(0., last), std::max(0., last));
  return { last, torques_of(*curve, now.motion.orbit, last) };
}

void SpinUps::begin(const Study &now, const VectorXd &place)
{
  constexpr double margin = 1.05; // for terminal spins whose ratio to the first harmonic's is another
  const SharedLoad load = load_of(now);
  const double last = margin * last_spin_of(*load, now, false);
  stretch = 1;
  stretch = last / first_harmonic(now).last;
  if (!(stretch > 0))
    throw ring::NoBalance("the first harmonic turns the other way");
  const ring::SharedLoad curve = ring::interpolated(load, std::min(0., last), std::max(0., last));
  const FirstHarmonic first = first_harmonic(now);
  const VectorXd torques = torques_of(*curve, now.motion.orbit, last);
  beyond_first_harmonic.add(place, (torques - first.torques) / first.unit, true);
  add_solved(now, place, *load, true);
}

void SpinUps::add_solved(const Study &now, const VectorXd &place, const ring::LoadAtSpin &load,
                         bool is_centre)
{
  constexpr double enough = 1e-7; // of mu N R
  constexpr Index n_least = 4, n_most = 17;
  const FirstHarmonic first = first_harmonic(now);
  const VectorXd expected = beyond_first_harmonic.at(place), &shares = TorqueBySpin::shares();
  VectorXd missed = VectorXd::Zero(shares.size()); // the polynomial through Leja points of the spins
  VectorXd places(0), misses(0);
  double last_miss = 0;
  while (misses.size() < n_least || (last_miss > enough && misses.size() < n_most))
  {
    const Index i = next_point(places), n = misses.size();
    const double torque = ring::yaw_torque(load, now.motion.orbit, first.last * shares(i)),
                 miss = (torque - first.torques(i)) / first.unit - expected(i);
    constexpr double safety = 2; // the miss need not be largest there
    last_miss = safety * std::abs(miss - missed(i));
    places.conservativeResize(n + 1);
    misses.conservativeResize(n + 1);
    places(n) = shares(i);
    misses(n) = miss;
    for (Index k = 0; k < missed.size(); ++k)
      missed(k) = ring::lagrange_values(places, shares(k)).dot(misses);
  }
  if (is_centre)
    error = last_miss;
  beyond_first_harmonic.add(place, expected + missed, is_centre);
  forget_curves();
}

void SpinUps::solve_at(const VectorXd &x, bool is_centre)
{
  const VectorXd place = place_of(x);
  if (!is_interpolated || place.size() == 0)
    return;
  try
  {
    const Study now = moved_study.at(x);
    torque_at(now, place); // the first load, if there is none
    if (is_interpolated && beyond_first_harmonic.centre() != place)
      add_solved(now, place, *load_of(now), is_centre);
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
    interpolate_no_more();
  }
}

void SpinUps::interpolate_no_more()
{
  is_interpolated = false;
  error = 0;
  forget_curves();
}

void SpinUps::forget_curves()
{
  torques.clear();
  spin_ups.clear();
  derivatives.clear();
}

const TorqueBySpin &SpinUps::torque_at(const Study &now, const VectorXd &place)
{
  const auto known = torques.find(key_of(place));
  if (known != torques.end())
    return known->second;
  if (is_interpolated && beyond_first_harmonic.empty())
    try
    {
      begin(now, place);
    }
    catch (const std::exception &failure)
    {
      if (!is_variant_failure(failure))
        throw;
      interpolate_no_more();
    }
  const std::optional<TorqueBySpin> interpolated =
    is_interpolated ? interpolated_torque(now, place) : std::nullopt;
  return torques.emplace(key_of(place), interpolated ? *interpolated : solved_torque(now)).first->second;
}

std::optional<TorqueBySpin> SpinUps::interpolated_torque(const Study &now, const VectorXd &place) const
{
  const auto first = ring::if_balanced([&] { return first_harmonic(now); });
  if (!first)
    return std::nullopt;
  const TorqueBySpin torque(first->last, first->torques + first->unit * beyond_first_harmonic.at(place));
  const bool is_slowed = torque(first->last) * first->last < 0;
  return is_slowed ? std::optional(torque) : std::nullopt;
}

const SpinUp &SpinUps::at(const VectorXd &x)
{
  constexpr double n_time_constants = 60; // of the spin without grip
  const auto known = spin_ups.find(key_of(x));
  if (known != spin_ups.end())
    return known->second;
  const Study now = moved_study.at(x);
  const TorqueBySpin torque = torque_at(now, place_of(x));
  const ring::Motion &motion = now.motion.orbit;
  const double scale = motion.orbit_speed / radius_of(now);
  const SpinUp spin_up({ torque, now.motion.grip_torque, motion.yaw_inertia }, scale,
                       n_time_constants / SpinUp::n_steps * motion.yaw_inertia * scale / unit_torque(now));
  if (std::abs(spin_up.last_spin()) > std::abs(torque.last_spin()))
    throw ring::NoBalance("the glass tips while it spins up");
  return spin_ups.emplace(key_of(x), spin_up).first->second;
}

SpinCourse SpinUps::missed(const VectorXd &x)
{
  const double torque = error * unit_torque(moved_study.at(x));
  return at(x).derivative([=](double) { return torque; });
}

const SpinCourse &SpinUps::derivative(const VectorXd &x, Index j)
{
  const std::pair key(key_of(x), j);
  const auto known = derivatives.find(key);
  return known != derivatives.end() ? known->second
                                    : derivatives.emplace(key, find_derivative(x, j)).first->second;
}

SpinCourse SpinUps::find_derivative(const VectorXd &x, Index j)
{
  const SpinUp spin_up = at(x);
  const FitParameter &parameter = parameters[static_cast<std::size_t>(j)];
  const double slope = parameter.slope(x(j));
  const SpinUpTorque &torque = spin_up.torque();
  if (parameter.is_grip())
    return spin_up.derivative([&](double omega)
                              { return -slope * std::copysign(1., omega == 0 ? torque.free(0) : omega); });
  if (parameter.is_inertia())
    return spin_up.derivative([&](double omega) { return -slope / torque.yaw_inertia * torque(omega); });
  // One of the two ways may be beyond a fall; a load that is solved takes long.
  constexpr double step = 1e-3;
  const bool is_cheap = is_interpolated || !study.load.is_from_contact();
  std::vector<std::pair<double, TorqueBySpin>> found;
  for (const double way : { step, -step })
    try
    {
      VectorXd moved = x;
      moved(j) += way;
      if (is_cheap || found.empty())
      {
        const Study now = moved_study.at(moved);
        found.emplace_back(way, torque_at(now, place_of(moved)));
      }
    }
    catch (const std::exception &failure)
    {
      if (!is_variant_failure(failure))
        throw;
    }
  if (found.empty())
    return spin_up.derivative([](double) { return 0; });
  if (found.size() < 2)
    found.emplace_back(0, torque.free);
  const auto &[one, of_one] = found[0];
  const auto &[other, of_other] = found[1];
  return spin_up.derivative([&, from = other, to = one, &before = of_other, &after = of_one](double omega)
                            { return (after(omega) - before(omega)) / (to - from); });
}

} // namespace stemware::pipeline
