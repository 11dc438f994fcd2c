#include "fem/pipeline/result/sentences.h"

#include "fem/pipeline/result/number_format.h"

#include <cctype>
#include <cmath>

namespace stemware::pipeline
{

using format::number;

void append(std::string &text, const std::string &sentence)
{
  text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
}

std::string one_way_word(const LoadSection &load)
{
  return load.is_one_way() ? "one-way " : "";
}

std::string under_its_load(const LoadSection &load, std::string sentence)
{
  if (!load.is_one_way())
    return sentence;
  sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  if (load.source == LoadSource::file)
    return "With the given load, constant over the spin (one-way), " + sentence;
  return std::string(load.is_static() ? "With the given moment and" : "With") +
         " the load at rest kept at every spin (one-way), " + sentence;
}

std::string sense_of(const ring::Motion &motion, double omega)
{
  const bool is_with_orbit = omega * motion.sense_sign() > 0;
  return std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
         (is_with_orbit ? "with" : "against") + " its orbit";
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
  const std::string opening = "The higher harmonics of the " + one_way_word(study.load) + "load ",
                    change = number(*effect.absolute, "+.3g") +
                             (band && *band > 0.1 * std::abs(*effect.absolute) ? " ± " + number(*band, "band")
                                                                               : "") +
                             " rad/s";
  if (!study.is_spin(*effect.absolute))
    return opening + "change the spin by less than " + number(study.rounding_of_spins(), ".2g") + " rad/s.";
  if (effect.relative)
    return opening + "make the spin " + faster_or_slower(*effect.relative) + " (" + change + ").";
  return opening + "change the spin by " + change + ".";
}

std::string fall_sentences(const ring::Motion &motion, const ring::Answer &all)
{
  const ring::Fall &fall = all.fall.value();
  return "The glass stands at rest and tips over while it spins up, at " +
         number(std::abs(fall.omega), ".3g") + " rad/s " + sense_of(motion, fall.omega) +
         ", where the moment ratio is " + number(fall.state.moment_ratio, ".3g") +
         ": no contact pressure balances a larger moment. There is no terminal spin. At rest the moment "
         "ratio is " +
         number(all.at_rest.value().moment_ratio, ".4g") + " and the torque of friction is " +
         number(all.at_rest.value().friction.torque, ".4g") + " N m.";
}

} // namespace stemware::pipeline
