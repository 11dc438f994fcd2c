#include "fem/pipeline/result/sentences.h"

#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/result/number_format.h"

#include <boost/math/constants/constants.hpp>

#include <cctype>
#include <cmath>

namespace stemware::pipeline
{

using format::number;

void append(std::string &text, const std::string &sentence)
{
  text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
}

bool is_one_way(const Study &study)
{
  return study.load.source == LoadSource::file || study.load.is_static() ||
         (study.load.is_from_contact() && study.load.coupling == LoadCoupling::one_way);
}

std::string one_way_word(const Study &study)
{
  return is_one_way(study) ? "one-way " : "";
}

std::string under_its_load(const Study &study, std::string sentence)
{
  if (!is_one_way(study))
    return sentence;
  sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  if (study.load.source == LoadSource::file)
    return "With the given load, constant over the spin (one-way), " + sentence;
  return std::string(study.load.is_static() ? "With the given moment and" : "With") +
         " the load at rest kept at every spin (one-way), " + sentence;
}

std::string sense_of(const Study &study, double omega)
{
  const bool is_with_orbit = omega * study.motion.orbit.sense_sign() > 0;
  return std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
         (is_with_orbit ? "with" : "against") + " its orbit";
}

double seconds_a_turn(double omega)
{
  return boost::math::double_constants::two_pi / std::abs(omega);
}

std::string faster_or_slower(double change)
{
  return number(std::abs(change), ".3g%") + (change > 0 ? " faster" : " slower");
}

std::string torque_effect_sentence(const ring::TorqueEffects &effects)
{
  if (effects.rows.size() < 2 || !effects.rows.back().half || effects.torque_at_rest == 0)
    return "";
  const ring::TorqueEffect &all = effects.rows.back();
  const auto relative = [&](double torque) { return number(torque / effects.torque_at_rest, "+.3g%"); };
  if (!(std::abs(all.largest.value_or(all.half->change)) > 1e-9 * effects.torque_at_rest))
    return "The harmonics beyond the first do not change the torque of friction at any spin.";
  std::string text = "At half the terminal spin the harmonics beyond the first change tau_z of friction by " +
                     number(all.half->change, "+.3g") + " N m (" + relative(all.half->change) +
                     " of |tau_z| at rest)";
  if (all.largest)
    text += ", at most by " + relative(*all.largest) + ", at " + number(*all.largest_at, ".3g") + " rad/s";
  return text + "; at rest by nothing, for every contact.";
}

std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect,
                                     const std::optional<double> &band)
{
  if (!effect.absolute)
    return "";
  const std::string opening = "The higher harmonics of the " + one_way_word(study) + "load ",
                    change = number(*effect.absolute, "+.3g") +
                             (band && *band > 0.1 * std::abs(*effect.absolute) ? " ± " + number(*band, "band")
                                                                               : "") +
                             " rad/s";
  if (!is_spin(study, *effect.absolute))
    return opening + "change the spin by less than " + number(rounding_of_spins(study), ".2g") + " rad/s.";
  if (effect.relative)
    return opening + "make the spin " + faster_or_slower(*effect.relative) + " (" + change + ").";
  return opening + "change the spin by " + change + ".";
}

std::string fall_sentences(const Study &study, const ring::Answer &all)
{
  const ring::Fall &fall = all.fall.value();
  return "The glass stands at rest and tips over while it spins up, at " +
         number(std::abs(fall.omega), ".3g") + " rad/s " + sense_of(study, fall.omega) +
         ", where the moment ratio is " + number(fall.state.moment_ratio, ".3g") +
         ": no contact pressure balances a larger moment. There is no terminal spin. At rest the moment "
         "ratio is " +
         number(all.at_rest.value().moment_ratio, ".4g") + " and the torque of friction is " +
         number(all.at_rest.value().friction.torque, ".4g") + " N m.";
}

std::string lift_off_sentences(const std::vector<std::pair<std::string, const LoadReport *>> &states)
{
  std::string text;
  for (const auto &[state, load] : states)
  {
    const std::string share = number(load->contact_fraction, ".1f%") + " of the land is under pressure";
    if (load->minimum < 0)
      append(text, state + " the load is negative somewhere, down to " + number(load->minimum, ".4g") +
                     " N/rad (tensile, not physical). " + share + ".");
    else if (load->contact_fraction < 1)
      append(text,
             state + " the foot has partly lifted off: " + share + ", at a moment ratio of " +
               number(load->moment_ratio, ".4g") +
               (load->moment_ratio > 1 ? " (above 1 a first-harmonic load is negative somewhere)." : "."));
  }
  return text;
}

} // namespace stemware::pipeline
