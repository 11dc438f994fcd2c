#include "fem/pipeline/output/answer.h"

#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change)
{
  return formatted("%.3g %% %s", 100 * std::abs(change), change > 0 ? "faster" : "slower");
}

/// Decimals that show two digits of @p spread.
int decimals_of(double spread)
{
  constexpr int of_nothing = 6;
  return spread > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(spread)))) : of_nothing;
}

std::string terminal_spin(const StudyResult &result)
{
  if (!result.yaw.spins_up())
    return "The glass does not spin up.";
  return "The glass spins up to " +
         with_band(result.yaw.terminal.omega, band_of(result.error_bands, "omega_terminal")) + " rad/s.";
}

std::string harmonic_sentence(const SpinComparison &spins, const StudyResult &result)
{
  const auto change = spins.harmonic_effect();
  if (!change || result.load.at_rest.n_harmonics() < 2)
    return "";
  if (std::abs(*change) < 1e-9)
    return " The harmonics of the load beyond the first do not change that.";
  return " The harmonics of the load beyond the first make it " + faster_or_slower(*change) +
         formatted(" than the first alone would (%#.6g rad/s).", spins.first_harmonic);
}

} // namespace

std::string answer(const Study &study, const StudyResult &result)
{
  const SpinComparison spins = compare_spins(study, result);
  return terminal_spin(result) + harmonic_sentence(spins, result) + closure_sentence(spins);
}

std::string closure_sentence(const SpinComparison &spins)
{
  const auto change = spins.closure_effect();
  if (!change)
    return "";
  return formatted(
    " For comparison: with a first-harmonic load, what the paper's balance of moments leaves out makes the "
    "glass %s (%#.6g instead of %#.6g rad/s%s).",
    faster_or_slower(*change).c_str(), *spins.complete_closure, *spins.paper_closure,
    spins.is_formal ? ", formally: such a load would have to pull on the table" : "");
}

std::string lift_off_remark(const RingLoad &load)
{
  if (load.moment_ratio <= 1)
    return "";
  return formatted("The moment ratio is %.4g, above 1: a first-harmonic load would have to pull; %.1f %% of "
                   "the rim carries load.",
                   load.moment_ratio, 100 * load.contact_fraction);
}

std::string narrow_contact_remark(const Study &study, const std::optional<ContactFigures> &contact)
{
  if (!contact || contact->result.solution.outcome != fem::ContactOutcome::narrow_contact)
    return "";
  return formatted(
    "Contact is narrow, at most %u of its nodes side by side: %s.", contact->result.solution.n_nodes_across,
    study.table.kind == TableKind::rigid
      ? "on a rigid table the load then depends on the mesh; give more Radial cells on a narrower land"
      : "the table's pressure is integrated exactly, the foot's indentation just under it is not resolved");
}

std::string waviness_remark(const Study &study, const std::optional<PhaseFigures> &phases)
{
  if (!phases)
    return "";
  const bool rim = !study.glass.waviness.empty(), table = !study.table.waviness.empty();
  const std::string who = rim && table ? "Rim and table are" : rim ? "The rim is" : "The table is";
  return who +
         formatted(" out of flat: the terminal spin is the mean in the long run, about which the spin swings "
                   "by %.3g rad/s, as the torque does by %.3g N m.",
                   phases->spin_ripple, phases->torque_ripple);
}

std::string to_spread(double value, double spread)
{
  return formatted("%.*f", decimals_of(spread), value);
}

std::string with_band(double value, const std::optional<double> &band)
{
  if (!band || !(*band > 0))
    return formatted("%#.6g", value);
  // Rounded up so that the band does not become narrower.
  const double unit = std::pow(10, -decimals_of(*band));
  return to_spread(value, *band) + " ± " + to_spread(std::ceil(*band / unit * (1 - 1e-9)) * unit, *band);
}

} // namespace stemware::pipeline
