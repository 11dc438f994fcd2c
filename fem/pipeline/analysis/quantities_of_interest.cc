#include "fem/pipeline/analysis/quantities_of_interest.h"

#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/base/numbers.h"
#include "ring_model/failures.h"
#include "ring_model/spin/curves.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

std::string QuantityOfInterest::title() const
{
  return omega ? boost::replace_all_copy(name, "*", to_short_text(*omega)) : name;
}

std::vector<QuantityOfInterest> load_quantities(const LoadReport &load, double share_noise)
{
  const auto rounding = [&](const Quantity &quantity, double value)
  {
    if (quantity.key == "contact_fraction" || quantity.key == "azimuth_fraction")
      return 0 < value && value < 1 ? share_noise : 0.;
    return relative_noise * (quantity.unit == "1"       ? 1
                             : quantity.unit == "N/rad" ? load.a(0)
                                                        : std::abs(value));
  };
  std::vector<QuantityOfInterest> quantities;
  for (const auto &[quantity, value_of] : load_fields().all())
    if (!quantity.banded.empty())
      if (const Json value = value_of(load); !value.is_null())
        quantities.push_back(
          { quantity.key, quantity.banded, quantity.unit, value, rounding(quantity, value.get<double>()) });
  return quantities;
}

QuantityOfInterest spin_quantity(const std::string &key, double value, double rounding)
{
  for (const auto &[quantity, value_of] : study_quantities().all())
    if (quantity.key == key && !quantity.banded.empty())
      return { key, quantity.banded, quantity.unit, value, rounding };
  throw std::out_of_range("no quantity of interest is called " + key);
}

std::vector<QuantityOfInterest> quantities_of_interest(const Study &study, const LoadReport &at_rest,
                                                       const Eigen::Vector3d &table_motion,
                                                       const ring::Answer &answer,
                                                       const std::vector<std::pair<double, double>> &torques)
{
  const ContactSection &contact = study.contact;
  // The contact fraction of a solid foot is accurate to one azimuthal cell. For a body of revolution, the
  // contact edges are interpolated between the azimuth lines.
  std::vector<QuantityOfInterest> quantities = load_quantities(
    at_rest, contact.is_of_revolution() ? relative_noise : 1. / contact.resolution.azimuthal_cells);
  const double torque_noise = relative_noise * study.motion.orbit.friction_at_rest() *
                              at_rest.normal_force() * study.glass.profile.contact_radius;
  constexpr double noise_of_slopes = 1e3; // factor between the relative noise of slopes and of torques
  for (const auto &[quantity, value_of] : answer_fields().all())
    if (!quantity.banded.empty())
    {
      const Json found = value_of(answer);
      const double value = found.is_null() ? std::nan("") : found.get<double>();
      const double rounding = quantity.unit == "N m"     ? torque_noise
                              : quantity.unit == "rad/s" ? study.rounding_of_spins()
                                                         : noise_of_slopes * relative_noise * value;
      quantities.push_back({ quantity.key, quantity.banded, quantity.unit, value, rounding });
    }
  for (std::size_t i = 0; i < torques.size(); ++i)
    quantities.push_back({ "tau_at_spin_" + std::to_string(i + 1), "torque of friction at * rad/s", "N m",
                           torques[i].second, torque_noise, torques[i].first });
  const double radius = at_rest.mean_radius,
               move_noise =
                 relative_noise * (std::abs(table_motion(0)) + radius * table_motion.tail<2>().norm());
  for (unsigned int i = 0; i < 3; ++i)
  {
    const std::string order = std::to_string(i);
    quantities.push_back(
      { "table_motion_" + order,
        std::string("table ") + (i == 0 ? "moved" : "tilted") + " by q_" + order + " at rest",
        i == 0 ? "m" : "rad", table_motion(i), i == 0 ? move_noise : move_noise / radius });
  }
  return quantities;
}

std::vector<QuantityOfInterest> quantities_of_load(const Study &study, const BalancedLoad &load,
                                                   std::vector<double> spins,
                                                   const std::optional<double> &omega_guess)
{
  ring::Question question = { study.motion.orbit };
  question.initial_guess = omega_guess.value_or(0);
  question.with_slope = true;
  const ring::Answer row = ring::answer(load, question).value();
  if (!row.terminal)
    throw ring::NoBalance(row.reason + "; a study of refinement needs a terminal spin");
  if (spins.empty())
    spins = spins_of_interest(row.terminal->omega);
  const std::vector<ring::Torques> at_spins = ring::torque_curve(load, question, spins);
  std::vector<std::pair<double, double>> torques;
  for (std::size_t i = 0; i < spins.size(); ++i)
    torques.emplace_back(spins[i], at_spins[i].friction.torque);
  return quantities_of_interest(study, load.report(), load.contact(0).value().solution.motion, row, torques);
}

bool BandedQuantity::is_zero() const
{
  return std::abs(quantity.value) <= quantity.rounding && std::abs(richardson) <= quantity.rounding;
}

std::vector<double> spins_of_interest(double omega_terminal)
{
  return { 0.5 * omega_terminal, 1.5 * omega_terminal };
}

const QuantityOfInterest &quantity_of(const std::vector<QuantityOfInterest> &quantities,
                                      const std::string &key)
{
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const QuantityOfInterest &quantity) { return quantity.key == key; });
  if (found == quantities.end())
    throw std::out_of_range("no quantity of a refinement study is called " + key);
  return *found;
}

std::string key_of(Goal goal)
{
  static constexpr const char *keys[] = { "", "omega_terminal", "a2", "tau_at_spin_1" };
  return keys[static_cast<std::size_t>(goal)];
}

ErrorBands::const_iterator find_quantity(const ErrorBands &quantities, const std::string &key)
{
  return std::find_if(quantities.begin(), quantities.end(),
                      [&](const BandedQuantity &banded) { return banded.quantity.key == key; });
}

std::size_t index_of(const ErrorBands &quantities, const std::string &key)
{
  const auto found = find_quantity(quantities, key);
  if (found == quantities.end())
    throw std::out_of_range("no quantity of interest is called " + key);
  return static_cast<std::size_t>(found - quantities.begin());
}

std::optional<double> band_of(const ErrorBands &quantities, const std::string &key)
{
  const auto found = find_quantity(quantities, key);
  return found == quantities.end() ? std::nullopt : std::optional(found->band);
}

} // namespace stemware::pipeline
