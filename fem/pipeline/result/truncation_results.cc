#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/curves.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/verb_results.h"

#include <cmath>

namespace stemware::pipeline
{

using format::number;

namespace
{

/// Returns the smallest sufficient number of harmonics: with this number or more, the terminal spin deviates
/// from the spin of the last row (all harmonics) by at most the fraction @p share.
unsigned int harmonics_enough(const StudyRows &rows, double share)
{
  unsigned int enough = rows.answer().harmonics;
  for (auto loaded = rows.by_harmonics.rbegin(); loaded != rows.by_harmonics.rend(); ++loaded)
  {
    const ring::Answer &row = loaded->row;
    if (!row.relative_change || std::abs(*row.relative_change) > share)
      break;
    enough = row.harmonics;
  }
  return enough;
}

/// Returns the answer in words. @p n_enough: number of harmonics with which the spin is accurate to 1e-4 of
/// its value.
std::string answer_of(const StudyAnswer &answer, unsigned int n_enough)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  const ring::Answer &all = spin.answer();
  const std::optional<double> first = spin.rows.omega_first_harmonic();
  if (all.fall)
  {
    std::string text = fall_sentences(study.motion.orbit, all);
    if (spin.rows.by_harmonics.size() > 1)
      append(text, first
                     ? "The first harmonic only has a terminal spin of " + format::spin(*first) + " rad/s."
                     : "The first harmonic only has no terminal spin either.");
    return text;
  }
  const double omega = all.omega_terminal().value();
  if (!study.is_spin(omega))
  {
    const std::string held = grip_holds_note(study.motion.grip_torque, all);
    return held.empty() ? "The glass does not spin up, with any number of harmonics." : held;
  }
  if (all.harmonics == 1)
    return "The " + one_way_word(study.load) + "load has one harmonic; the terminal spin is " +
           format::spin(omega) + " rad/s.";
  std::string text = under_its_load(
    study.load, "The glass spins up to " + format::spin(omega) + " rad/s with all " +
                  std::to_string(all.harmonics) + " harmonics of its load, " +
                  (first ? "to " + format::spin(*first) + " rad/s with the first harmonic only."
                         : "and has no terminal spin with the first harmonic only."));
  append(text, torque_effect_sentence(spin.torque_effects));
  append(text, harmonic_effect_sentence(study, harmonic_effect(spin.rows)));
  append(text, "From " + std::to_string(n_enough) + " harmonics on, the spin is accurate to 1e-4.");
  return text;
}

} // namespace

Fields<StudyAnswer> truncate_fields()
{
  return Fields<StudyAnswer>{
    { "fall", "Of `truncate`: as ring.fall of `run`.", fall_fields(),
      [](const StudyAnswer &answer) { return answer.spin.answer().fall; } }
  }.include(harmonics_fields(), [](const StudyAnswer &answer) -> const StudyAnswer & { return answer; });
}

Results truncation_results(const StudyAnswer &answer)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  const std::optional<double> omega = spin.answer().omega_terminal();
  const unsigned int n_enough = harmonics_enough(spin.rows, 1e-4);
  const std::vector<Truncation> truncations = truncations_of(spin);
  const HarmonicEffect effect = harmonic_effect(spin.rows);
  Results results = begun_results(study, "how many harmonics of the load matter");
  results.summary = truncate_fields().json(answer);
  results.key_figures = { { "omega_terminal", omega },
                          { "harmonic_effect", effect.absolute },
                          { "harmonic_effect_relative", effect.relative },
                          { "harmonics_for_1e-4", omega ? Json(n_enough) : Json(nullptr) } };
  results.words["answer"] = answer_of(answer, n_enough);
  add_load_lines(contact.load, results);
  add_truncations(answer, results);
  results.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study as input file" },
                    { "truncation.csv", "the answer with 1, 2, 3, 4, 6, 8 ... harmonics",
                      truncation_fields().table(truncations, Face::file) },
                    { "torque_changes.csv", "effect of the harmonics 2 ... n on τ_z against the spin",
                      torque_change_columns(spin.torque_effects)
                        .table(points_of(spin.torque_effects.spins.size()), Face::file) },
                    { "timings.json", "how long it took" } };
  results.console = { results.words["answer"].get<std::string>(),
                      "The harmonics 2 ... n and tau_z: one load, the complete study's, cut after n. Rest: "
                      "all minus n. In per "
                      "cent of |tau_z| at rest. " +
                        std::string(study.load.is_one_way()
                                      ? "The spins are those of the load at rest, cut after n."
                                      : "Each terminal spin is a balance of its own."),
                      truncation_fields().table(shown_truncations(truncations), Face::console) };
  return results;
}

} // namespace stemware::pipeline
