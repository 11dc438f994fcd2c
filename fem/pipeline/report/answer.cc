#include "fem/pipeline/report/answer.h"

#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/report/render/number_format.h"
#include "fem/pipeline/support/text.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change)
{
  return format::percent<3>(std::abs(change)) + (change > 0 ? " faster" : " slower");
}

/// " (moment balance: +17.9 %)"; empty where one of the spins does not exist, or the first is rounding.
std::string change_in_brackets(const std::string &name, const SpinRow &from, const SpinRow &to,
                               double spin_scale)
{
  const auto before = from.omega_terminal(), after = to.omega_terminal();
  const auto change =
    before && after ? relative_to(before, *after - *before, spin_scale) : std::optional<double>();
  return change ? " (" + name + ": " + format::change(*change) + ")" : "";
}

// ---- run

/// "one turn in 1.72 s".
std::string duration_of_a_turn(double omega)
{
  return "one turn in " +
         format::all_significant<3>(boost::math::double_constants::two_pi / std::abs(omega)) + " s";
}

/// "clockwise, against its orbit": as seen from above.
std::string sense_of(const Study &study, double omega)
{
  const bool is_with_orbit = omega * study.motion.orbit.sense_sign() > 0;
  return std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
         (is_with_orbit ? "with" : "against") + " its orbit";
}

std::string terminal_spin_sentence(const Study &study, const SpinStudy &spin,
                                   const std::vector<BandedQuantity> &bands)
{
  const std::string beginning = one_way_beginning(study);
  const double omega = spin.all().omega_terminal().value();
  const std::optional<double> band = band_of(bands, "omega_terminal"),
                              error = spin_error(spin.profile_scatter);
  const bool profile_is_wider = error && *error > band.value_or(0);
  return beginning + (beginning.empty() ? "The" : "the") + " glass spins " + sense_of(study, omega) + ", " +
         duration_of_a_turn(omega) + ": " +
         (profile_is_wider ? with_error(omega, *error) + " rad/s (scatter of the profile)."
                           : with_band(omega, band) + " rad/s.");
}

/// Of a glass that stands at rest and tips on the way.
std::string fall_sentences(const Study &study, const SpinRow &all)
{
  const Fall &fall = all.fall.value();
  const RingState &rest = all.at_rest.value();
  return "The glass stands at rest and falls over on the way: turning " + sense_of(study, fall.omega) +
         " at " + format::significant<3>(std::abs(fall.omega)) + " rad/s it has reached a moment ratio of " +
         format::significant<3>(fall.state.moment_ratio) +
         ", and beyond that no load that only pushes keeps it in balance. It has no terminal spin. At rest "
         "its "
         "moment ratio is " +
         format::significant<4>(rest.moment_ratio) + " and friction turns it with a torque of " +
         format::significant<4>(rest.friction.torque) + " N m.";
}

/// The paper's answer, to stand beside the study's; empty where the study is the paper's model.
std::string paper_sentence(const Study &study, const Budget &budget)
{
  if (budget.rows.size() < 2 || !budget.rows.front().omega_terminal)
    return "";
  const double omega = *budget.rows.front().omega_terminal;
  return is_spin(study, omega) ? "In the paper's model it makes " + duration_of_a_turn(omega) + ": " +
                                   format::all_significant<6>(omega) + " rad/s."
                               : "In the paper's model it does not spin up.";
}

/// Of a glass that does not spin up: by itself, or because the fingers hold it.
std::string at_rest_sentence(const Study &study, const SpinRow &all, const std::string &whatever)
{
  const std::string held = held_by_the_grip(study, all);
  return held.empty() ? "The glass does not spin up" + whatever + "." : held;
}

/// The row whose step is the largest, those of the harmonics left out; null where none of them is a spin.
const BudgetRow *largest_other_step(const Study &study, const Budget &budget)
{
  const BudgetRow *largest = nullptr;
  for (const BudgetRow &row : budget.rows)
    if (row.name != "harmonics" && row.difference && is_spin(study, *row.difference) &&
        (!largest || std::abs(*row.difference) > std::abs(*largest->difference)))
      largest = &row;
  return largest;
}

std::string largest_step_sentence(const Study &study, const Budget &budget)
{
  const BudgetRow *row = largest_other_step(study, budget);
  if (!row)
    return "";
  const std::optional<double> relative =
    relative_to(*row->omega_terminal - *row->difference, row->difference, spin_scale(study));
  return "The largest other step from the paper's model to this " +
         std::string(is_one_way(study) ? "one-way one" : "one") + " is \"" + row->name +
         "\": " + format::signed_significant<3>(*row->difference) + " rad/s" +
         (relative ? " (" + faster_or_slower(*relative) + ")" : "") +
         (row->standing == Standing::formal ? ", formally: such a load would have to pull on the table"
                                            : "") +
         ".";
}

/// Why a contact's spin stands without a band.
std::string no_band_sentence(const Study &study)
{
  if (!study.load.is_from_contact())
    return "";
  const bool may_be_narrow = study.table.is_hard() && !abilities(study.contact.body).is_of_revolution;
  return std::string("It has no band: one of the contacts that would tell, coarser, finer or stiffer, could "
                     "not be had") +
         (may_be_narrow ? ", or the contact is narrower than the mesh's cells." : ".");
}

/// What no band contains, with its sizes.
std::string without_sentence(const Study &study, const Budget &budget, bool has_band)
{
  std::vector<std::string> parts;
  for (const WithoutRow &row : budget.without)
    if (row.difference)
      parts.push_back(row.name + " " +
                      format::signed_significant<2>(is_spin(study, *row.difference) ? *row.difference : 0));
  if (parts.empty())
    return "";
  return std::string(has_band ? "The band is that of the discretisation; it" : "This") +
         " does not contain what the " + (is_one_way(study) ? "one-way " : "") +
         "model leaves open. Left out one at a time, these change the spin by (rad/s): " +
         listed(parts, "and") + ".";
}

// ---- truncate

/// What the first harmonic alone and all of them lead to.
std::string both_spins_sentence(const Study &study, const TruncationStudy &truncations)
{
  const SpinRow &first = truncations.rows.front(), &all = truncations.all();
  const std::string beginning = one_way_beginning(study);
  return beginning + (beginning.empty() ? "The" : "the") +
         fmt::format(FMT_STRING(" glass spins up to {} rad/s with all {} harmonics of its load, "),
                     with_band(all.omega_terminal().value(), all.band), all.harmonics) +
         (first.omega_terminal()
            ? "to " + format::significant<6>(*first.omega_terminal()) + " rad/s with the first alone."
            : "and has no terminal spin with the first alone.");
}

// ---- compare

/// "-3.12056 rad/s", or why there is none.
std::string spin_of(const SpinRow &row)
{
  if (!row.omega_terminal())
    return "nothing (" + to_string(row.standing) + ")";
  return with_band(*row.omega_terminal(), row.band) + " rad/s" +
         (row.standing == Standing::formal ? ", formally" : "");
}

/// "-0.0295 rad/s, -0.81 %"; "0" for less than 1e-9 @p spin_scale.
std::string effect_text(const HarmonicEffect &effect, double spin_scale)
{
  if (std::abs(*effect.absolute) < 1e-9 * spin_scale)
    return "0";
  return format::signed_significant<3>(*effect.absolute) + " rad/s" +
         (effect.relative ? ", " + format::change(*effect.relative) : "");
}

} // namespace

std::string run_answer(const Study &study, const SpinStudy &spin, const std::vector<BandedQuantity> &bands)
{
  const std::string quick =
    spin.is_quick() ? "This was a quick run, without the budget of effects and without error bands." : "";
  if (spin.all().fall)
    return joined({ quick, fall_sentences(study, spin.all()), paper_sentence(study, spin.budget) });
  if (!is_spin(study, spin.all().omega_terminal().value()))
    return joined({ quick, at_rest_sentence(study, spin.all(), "") });
  const bool has_band = band_of(bands, "omega_terminal").has_value();
  return joined(
    { quick, terminal_spin_sentence(study, spin, bands),
      has_band || spin.is_quick() ? "" : no_band_sentence(study), paper_sentence(study, spin.budget),
      spin.rows.size() > 1 ? harmonic_effect_sentence(study, spin.budget.harmonics) : "",
      largest_step_sentence(study, spin.budget), without_sentence(study, spin.budget, has_band) });
}

bool is_one_way(const Study &study)
{
  return study.load.source == LoadSource::file || study.load.is_static() ||
         (study.load.is_from_contact() && study.load.coupling == LoadCoupling::one_way);
}

std::string harmonics_subject(const Study &study)
{
  return std::string("The harmonics of the ") + (is_one_way(study) ? "one-way " : "") +
         "load beyond the first ";
}

std::string one_way_beginning(const Study &study)
{
  if (!is_one_way(study))
    return "";
  if (study.load.source == LoadSource::file)
    return "Under the given load (one-way: it is the same at every spin) ";
  return (study.load.is_static() ? "Under the given moment, with" : "With") +
         std::string(" the load of rest kept at every spin (one-way), ");
}

std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect)
{
  if (!effect.absolute)
    return "";
  const std::string subject = harmonics_subject(study);
  if (!is_spin(study, *effect.absolute))
    return subject + "change that by less than " + format::significant<2>(1e-9 * spin_scale(study)) +
           " rad/s.";
  const std::string size = format::signed_significant<3>(*effect.absolute) + " rad/s";
  return subject + (effect.relative ? "make it " + faster_or_slower(*effect.relative) + " (" + size + ")."
                                    : "change it by " + size + ".");
}

std::string lift_off_remark(const LoadReport &load, const std::string &state)
{
  if (load.minimum < 0)
    return state + " the load is negative somewhere, down to " + format::significant<4>(load.minimum) +
           " N/rad: the table would have to pull. " + format::percent_fixed<1>(load.contact_fraction) +
           " of the rim carries load.";
  if (load.contact_fraction >= 1)
    return "";
  return state + " the foot has left the table in part: " + format::percent_fixed<1>(load.contact_fraction) +
         " of the rim carries load, at a moment ratio of " + format::significant<4>(load.moment_ratio) +
         (load.moment_ratio > 1 ? ", above 1, where a first-harmonic load would have to pull." : ".");
}

std::string narrow_contact_remark(const Study &study, const std::optional<FootReport> &foot)
{
  if (!foot || foot->at_rest.solution.outcome != fem::ContactOutcome::narrow_contact)
    return "";
  return fmt::format(
    FMT_STRING("Note: the contact is at most {} nodes wide: {}."), foot->at_rest.solution.n_nodes_across,
    study.table.is_hard()
      ? "on a hard table the load then depends on the mesh; give more Radial cells on a narrower land"
      : "the pressure is integrated exactly across it, but the mesh does not resolve how the foot yields "
        "just above it");
}

std::string layer_remark(const Study &study, double half_width)
{
  const double layer = study.table.layer_thickness;
  if (study.table.interface != TableInterface::winkler || !(layer > 0) || !(half_width > 0) ||
      half_width >= layer)
    return "";
  return fmt::format(
    FMT_STRING(
      "Note: the contact is {:.2g} mm wide, its half-width less than the {:.3g} mm of the layer "
      "(Table/Layer thickness). A Winkler interface stands for a layer only where the contact is much "
      "wider than it; take an elastic disc instead (Table/Substrate = elastic)."),
    2e3 * half_width, 1e3 * layer);
}

std::string waviness_remark(const Study &study, const std::optional<PhaseStudy> &phases)
{
  if (!phases)
    return "";
  const bool rim = !study.glass.waviness.empty(), table = !study.table.waviness.empty();
  return fmt::format(FMT_STRING("{} out of flat: the terminal spin is the mean in the long run, about which "
                                "the spin swings by {:.3g} rad/s, and the torque by {:.3g} N m."),
                     rim && table ? "Rim and table are" : (table ? "The table is" : "The rim is"),
                     format::Number{ phases->spin_ripple }, format::Number{ phases->torque_ripple });
}

std::string truncation_answer(const Study &study, const TruncationStudy &truncations)
{
  const SpinRow &all = truncations.all();
  if (!is_spin(study, all.omega_terminal().value()))
    return at_rest_sentence(study, all, ", whatever harmonics its load has");
  if (all.harmonics == 1)
    return one_way_beginning(study) + "The load has one harmonic; the terminal spin is " +
           with_band(*all.omega_terminal(), all.band) + " rad/s.";
  return joined({ both_spins_sentence(study, truncations),
                  harmonic_effect_sentence(study, truncations.harmonics),
                  fmt::format(FMT_STRING("From {} harmonics on the spin is right to 1e-4."),
                              harmonics_enough(truncations.rows, 1e-4)) });
}

std::string comparison_answer(const Comparison &comparison)
{
  using ring::Closure;
  const std::string &load = comparison.rows.back().load; // the study's own, the last
  const auto first = [&](Closure closure) -> const SpinRow &
  { return *comparison.find(closure, compared_load::first_harmonic); };
  const auto all_harmonics = [&](Closure closure)
  {
    const HarmonicEffect effect = comparison.harmonic_effect(closure, load);
    return spin_of(*comparison.find(closure, load)) +
           (effect.absolute ? " (harmonics: " + effect_text(effect, comparison.spin_scale) + ")" : "");
  };
  if (std::none_of(comparison.rows.begin(), comparison.rows.end(),
                   [&](const SpinRow &row)
                   { return std::abs(row.omega_terminal().value_or(0)) >= 1e-9 * comparison.spin_scale; }))
    return "The glass does not spin up, whatever its load and its moment balance.";
  return "With the paper's moment balance a first-harmonic load reaches " + spin_of(first(Closure::paper)) +
         "; with the friction that this balance leaves out, " + spin_of(first(Closure::full)) +
         change_in_brackets("moment balance", first(Closure::paper), first(Closure::full),
                            comparison.spin_scale) +
         ". All harmonics of the " + name_of_load(load) + " reach, with the paper's balance, " +
         all_harmonics(Closure::paper) + ", and with the complete balance " + all_harmonics(Closure::full) +
         ".";
}

std::string name_of_load(const std::string &load)
{
  return load == compared_load::foot_at_rest ? load + " (one-way)" : load;
}

std::string refinement_answer(const RefinementResult &result)
{
  const std::size_t index = index_of(result.quantities, "omega_terminal");
  const BandedQuantity &spin = result.quantities[index];
  const AxisResult &first = result.axes.front();
  const auto &order = first.quantities[index].judged.order;
  return "Terminal spin " + with_band(spin.quantity.value, spin.band) + " rad/s (discretisation only)" +
         (order ? "; it converges with order " + format::fixed<2>(*order) + " in the " + first.axis.name
                : "") +
         ", Richardson value " + format::to_spread(spin.richardson, spin.band) + " rad/s.";
}

unsigned int harmonics_enough(const std::vector<SpinRow> &rows, double share)
{
  unsigned int enough = rows.back().harmonics;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
  {
    if (!row->relative_change || std::abs(*row->relative_change) > share)
      break;
    enough = row->harmonics;
  }
  return enough;
}

std::string joined(const std::vector<std::string> &sentences)
{
  std::string text;
  for (const std::string &sentence : sentences)
    text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
  return text;
}

std::string with_band(double value, const std::optional<double> &band)
{
  if (!band || !(*band > 0))
    return format::all_significant<6>(value);
  // Rounded up, so that what is printed contains all of value -/+ band.
  const double unit = std::pow(10, -format::decimals_of(*band));
  const double shift = std::abs(value - std::round(value / unit) * unit);
  return format::to_spread(value, *band) + " ± " +
         format::to_spread(std::ceil((*band + shift) / unit * (1 - 1e-9)) * unit, *band);
}

} // namespace stemware::pipeline
