#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{

using format::number;

namespace
{

double seconds_a_turn(double omega)
{
  return 2 * ring::pi / std::abs(omega);
}

std::string lift_off_sentences(const std::vector<std::pair<std::string, const LoadReport *>> &states)
{
  std::string text;
  for (const auto &[state, load] : states)
  {
    const std::string share = number(load->contact_fraction, ".1f%") + " of the land is under pressure";
    if (load->least < 0)
      append(text, fmt::format(FMT_STRING("{} the load is negative somewhere, down to {} N/rad (tensile, not "
                                          "physical). {}."),
                               state, number(load->least, ".4g"), share));
    else if (load->contact_fraction < 1)
      append(text, fmt::format(
                     FMT_STRING("{} the foot has partly lifted off: {}, at a moment ratio of {}{}."), state,
                     share, number(load->moment_ratio, ".4g"),
                     load->moment_ratio > 1 ? " (above 1 a first-harmonic load is negative somewhere)" : ""));
  }
  return text;
}

/// Returns the terminal spin of the paper's model, unless the study itself uses the paper's model.
std::optional<double> paper_spin(const std::optional<Budget> &budget)
{
  return !budget || budget->rows.size() < 2 ? std::nullopt : budget->rows.front().omega_terminal;
}

std::string paper_sentence(const StudyAnswer &run)
{
  const std::optional<double> omega = paper_spin(run.budget);
  if (!omega)
    return "";
  if (!run.study.is_spin(*omega))
    return "In the paper's model it does not spin up.";
  return std::string("The paper's rigid ring would ") + (run.spin.answer().fall ? "turn once in " : "take ") +
         number(seconds_a_turn(*omega), "#.3g") + " s.";
}

/// Describes the row with the largest change of the spin, except rows of harmonics and changes below
/// rounding.
std::string largest_step_sentence(const StudyAnswer &run, const Budget &budget)
{
  const BudgetRow *row = nullptr;
  for (const BudgetRow &each : budget.rows)
    if (each.name != "harmonics" && each.difference && run.study.is_spin(*each.difference) &&
        (!row || std::abs(*each.difference) > std::abs(*row->difference)))
      row = &each;
  if (!row)
    return "";
  const std::optional<double> relative =
    relative_to(*row->omega_terminal - *row->difference, row->difference, run.study.spin_scale());
  return "The largest correction to the paper's model is \"" + row->name + "\"" +
         (run.study.load.is_one_way() ? " (one-way): " : ": ") + number(*row->difference, "+.3g") + " rad/s" +
         (relative ? " (" + faster_or_slower(*relative) + ")" : "") +
         (row->status == ring::Status::formal
            ? "; the load of this step is negative somewhere (tensile, not physical)."
            : ".");
}

std::string inputs_sentence(const Budget &budget)
{
  std::string changes;
  for (const auto &[name, difference] : budget.inputs)
    changes += (changes.empty() ? "Inputs move the terminal spin (first harmonic, rigid ring): " : ", ") +
               name + " by " + number(difference, "+.2g") + " rad/s";
  return changes.empty() ? "" : changes + ".";
}

std::string missing_band_sentence(const TableSection &table, bool is_of_revolution)
{
  const bool may_be_narrow = table.is_hard() && !is_of_revolution;
  return std::string(
           "No error band: the contact failed on one of the coarser, finer or stiffer models that the "
           "band compares") +
         (may_be_narrow ? ", or the contact is narrower than the mesh's cells." : ".");
}

std::string spinning_answer(const StudyAnswer &run, double omega)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  const std::optional<double> band = band_of(bands, "omega_terminal"), paper = paper_spin(budget);
  std::string text =
    under_its_load(study.load, "The glass turns once in " + number(seconds_a_turn(omega), "#.3g") + " s, " +
                                 sense_of(study.motion.orbit, omega) + ".");
  append(text, paper_sentence(run));
  append(text,
         "The terminal spin is " + format::spin(omega, band) + " rad/s" +
           (band ? " (± " + number(*band, "band") + " rad/s by discretisation)" : "") +
           (paper && study.is_spin(*paper) ? ", the paper's " + format::spin(*paper) + " rad/s." : "."));
  if (!band && budget && study.load.is_from_contact())
    append(text, missing_band_sentence(study.table, study.contact.is_of_revolution()));
  if (spin.rows.by_harmonics.size() > 1)
  {
    append(text, torque_effect_sentence(spin.torque_effects));
    append(text,
           harmonic_effect_sentence(study, harmonic_effect(spin.rows), band_of(bands, "harmonic_effect")));
  }
  if (budget)
  {
    append(text, largest_step_sentence(run, *budget));
    append(text, inputs_sentence(*budget));
  }
  append(text, "docs/limits.md lists the effects missing in the " + one_way_word(study.load) +
                 "model, with the sizes that are known.");
  return text;
}

/// Describes the contact in @p state. An error band is added only if it exceeds a tenth of the value. The
/// bands computed at rest are used at every spin.
std::string pressed_sentence(const std::string &state, const LoadReport &load, const ErrorBands &bands)
{
  if (load.peak_pressure == 0)
    return "";
  const auto text = [&](const std::string &key, double value, const char *unit)
  {
    const std::optional<double> band = band_of(bands, key);
    return in_usual_unit(rounded(value, 3), unit) +
           (band && *band > 0.1 * value ? " ± " + in_usual_unit(rounded(*band, 2), unit) : "");
  };
  return state + " the largest pressure is " + text("peak_pressure", load.peak_pressure, "Pa") +
         (load.contact_width
            ? ", the contact at most " + text("contact_width", *load.contact_width, "m") + " wide."
            : ".");
}

std::string answer_of(const StudyAnswer &run)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  const ring::Answer &all = spin.answer();
  std::string text;
  if (!budget)
    text = "Quick run: no budget of effects, no error bands.";
  if (all.fall)
  {
    append(text, fall_sentences(study.motion.orbit, all));
    append(text, paper_sentence(run));
  }
  else if (const double omega = all.omega_terminal().value(); study.is_spin(omega))
    append(text, spinning_answer(run, omega));
  else if (const std::string held = grip_holds_note(study.motion.grip_torque, all); !held.empty())
    append(text, held);
  else
  {
    append(text, "The glass does not spin up.");
    if (all.terminal && !all.terminal->stable)
      append(text, "Rest is an unstable balance: any disturbance takes the glass to another terminal spin.");
  }
  constexpr double large_curve_error = 1e-3;
  if (const double error = spin.curve_error.value_or(0); error > large_curve_error)
    append(text, "Curves are interpolated between solved spins; their load is off by about " +
                   number(100 * error, "#.2g") + " % of its mean.");
  return text;
}

std::string profile_remark(const std::optional<fem::RimCircle> &circle)
{
  constexpr double rounding = 1e-9; // rounding of numbers in a file [m]
  if (!circle || circle->rms_distance <= rounding)
    return "";
  return "The points of the profile are " + number(1e6 * circle->rms_distance, ".2g") +
         " µm rms from the circle of its rim. No band contains this scatter; docs/cookbooks/own_profile.md "
         "shows how to compute its effect on the spin.";
}

/// Returns a remark on lift-off: at rest and at tipping if the glass tips; otherwise at the terminal spin or,
/// if there is no lift-off at the terminal spin, at rest.
std::string lift_off_remark(const StudyAnswer &run)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  if (spin.answer().fall)
    return lift_off_sentences(
      { { "At rest", &contact.load }, { "Where it tips over", &contact.load_at_end } });
  if (study.is_spin(*spin.answer().omega_terminal()))
  {
    if (study.load.is_one_way())
      return lift_off_sentences({ { "At every spin", &contact.load } });
    const char *at_end =
      spin.phases ? "At the terminal spin, at the phase of t = 0," : "At the terminal spin";
    if (const std::string text = lift_off_sentences({ { at_end, &contact.load_at_end } }); !text.empty())
      return text;
  }
  return lift_off_sentences({ { "At rest", &contact.load } });
}

std::string contact_remark(const StudyAnswer &run)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  std::string text = pressed_sentence("At rest", contact.load, bands);
  if (spin.answer().terminal && study.is_spin(spin.answer().terminal->omega))
    append(text, pressed_sentence("At the terminal spin", contact.load_at_end, bands));
  return text;
}

std::string narrow_contact_remark(const TableSection &table, const std::optional<FootReport> &foot)
{
  if (!foot || foot->at_rest.solution.outcome != fem::ContactOutcome::narrow_contact)
    return "";
  return "Note: the contact is at most " + std::to_string(foot->at_rest.solution.n_nodes_across) +
         " nodes wide: " +
         (table.is_hard()
            ? "on a hard table the load then depends on the mesh; increase Contact/Radial cells "
              "or reduce Glass/Land width."
            : "the pressure is integrated exactly, but the mesh does not resolve the "
              "deformation of the foot next to the contact.");
}

std::string thin_layer_remark(const TableSection &table, double half_width)
{
  const double layer = table.layer_thickness;
  if (table.interface != TableInterface::winkler || !(layer > 0) || !(half_width > 0) || half_width >= layer)
    return "";
  return "Note: the contact is " + number(1e3 * 2 * half_width, ".2g") +
         " mm wide; its half-width is less than the " + number(1e3 * layer, ".3g") +
         " mm of the layer (Table/Layer thickness). A Winkler interface represents a layer only if the "
         "contact is much wider than the layer is thick; use an elastic disc (Table/Substrate = elastic).";
}

std::string out_of_flat_remark(const StudyAnswer &run)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  if (!spin.phases)
    return "";
  const bool rim = !study.glass.waviness.empty(), table = !study.table.waviness.empty();
  return std::string(rim && table ? "Rim and table are out of flat"
                     : table      ? "The table is out of flat"
                     : rim        ? "The rim is out of flat"
                                  : "The foot is not round") +
         ": the terminal spin is a mean over time. The spin oscillates by ±" +
         number(spin.phases->spin_ripple, ".3g") + " rad/s about it, the torque by ±" +
         number(spin.phases->torque_ripple, ".3g") + " N m.";
}

std::string several_spins_remark(const std::vector<ring::TerminalSpin> &spins)
{
  if (spins.size() < 2)
    return "";
  const auto n_stable =
    std::count_if(spins.begin(), spins.end(), [](const ring::TerminalSpin &one) { return one.stable; });
  return "The torques add up to zero at " + std::to_string(spins.size()) + " spins, " +
         std::to_string(n_stable) + " of them stable; the initial spin decides which one the glass reaches.";
}

std::string driven_remark(const SpinStudy &spin, const ErrorBands &bands)
{
  const auto &driven = spin.spin_up.driven;
  if (!driven)
    return "";
  const auto [slowest, fastest] = std::minmax_element(driven->speed.begin(), driven->speed.end());
  std::string text =
    "With the speeds of Motion/Orbit speed file, " + number(*slowest, ".4g") + " to " +
    number(*fastest, ".4g") + " m/s, the glass spins at " +
    format::spin(driven->omega.back(), driven_band(spin, band_of(bands, "omega_terminal"))) +
    " rad/s at the end; with the constant Motion/Orbit speed, the basis of all other numbers, "
    "at " +
    format::spin(spin.spin_up.adaptive.back()) +
    " rad/s. Contact, friction and moments are in balance at every instant, including the force "
    "that accelerates the glass along its orbit. Linear interpolation of the file instead of the "
    "monotone cubic changes the spin by " +
    (driven->interpolation_change < 1e-9 // smaller changes are rounding errors
       ? "less than 1e-9 rad/s"
       : "up to " + number(driven->interpolation_change, ".1e") + " rad/s in between and " +
           number(driven->interpolation_change_at_end, ".1e") + " rad/s at the end");
  text += ".";
  if (const auto &start = driven->breakaway)
    text += " The glass rests until t = " + number(start->time, ".4g") +
            " s and begins to slide when the hand's force reaches " + number(start->force, ".4g") +
            " N, with a friction coefficient of " + number(start->motion.friction_coefficient, ".4g") +
            " and a moment ratio of " + number(start->moment_ratio, ".4g") + ".";
  return text;
}

} // namespace

Json run_words(const StudyAnswer &run)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = run;
  std::string answer = answer_of(run);
  append(answer, profile_remark(study.glass.rim_circle));
  return { { "answer", answer },
           { "lift_off", lift_off_remark(run) },
           { "pressed", contact_remark(run) },
           { "narrow_contact", narrow_contact_remark(study.table, contact.foot) },
           { "thin_layer", thin_layer_remark(study.table, contact.load.half_width()) },
           { "out_of_flat", out_of_flat_remark(run) },
           { "several_spins", several_spins_remark(spin.terminal_spins) },
           { "driven", driven_remark(spin, bands) },
           { "spin_unit", study.spin_unit() },
           { "rounding", study.rounding_of_spins() } };
}

} // namespace stemware::pipeline
