#include "fem/pipeline/result/truncation_results.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/result/answers.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/study_words.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all, which
/// is the last of @p rows; the last row's number without a terminal spin.
unsigned int harmonics_enough(const std::vector<ring::Answer> &rows, double share)
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

/// Source of the members of `truncate`'s summary.
struct TruncateRow
{
  const ring::Answer &all;
  HarmonicsRow harmonics;
};

const Fields<TruncateRow> &truncate_fields()
{
  static const auto fields = Fields<TruncateRow>{
    { "fall", "Of `truncate`: as ring.fall of `run`.", fall_fields(),
      [](const TruncateRow &row) { return row.all.fall; } }
  }.include(harmonics_fields(), &TruncateRow::harmonics);
  return fields;
}

} // namespace

Json truncate_schema()
{
  return truncate_fields().schema();
}

Results make_truncation_document(const Study &study, const LoadReport &load,
                                 const std::vector<ring::Answer> &rows, const ring::TorqueEffects &effects)
{
  const std::vector<Truncation> truncations = truncations_of(rows, effects, spin_scale(study));
  const std::optional<double> omega = rows.back().omega_terminal();
  const HarmonicEffect effect = harmonic_effect(rows.front().omega_terminal(), omega, spin_scale(study));
  const unsigned int n_enough = harmonics_enough(rows, 1e-4);
  Results results = { document_of(study, "how many harmonics of the load matter") };
  results.findings.summary = truncate_fields().json({ rows.back(), { load, effect, truncations } });
  results.findings.key_figures = { { "omega_terminal", omega },
                                   { "harmonic_effect", effect.absolute },
                                   { "harmonic_effect_relative", effect.relative },
                                   { "harmonics_for_1e-4", omega ? Json(n_enough) : Json(nullptr) } };
  results.words["answer"] = truncation_answer(study, rows, effects, effect, n_enough);
  add_load_lines(load, results);
  add_truncations(truncations, effects, results);
  results.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study as input file" },
                    { "truncation.csv", "the answer with 1, 2, 3, 4, 6, 8 ... harmonics",
                      truncation_fields().table(truncations, Face::file) },
                    { "torque_changes.csv", "effect of the harmonics 2 ... n on τ_z against the spin",
                      torque_change_table(effects) },
                    { "timings.json", "how long it took" } };
  results.console = { { results.words["answer"] },
                      { "The harmonics 2 ... n and tau_z: one load, the complete study's, cut after n. Rest: "
                        "all minus n. In per "
                        "cent of |tau_z| at rest. " +
                          std::string(is_one_way(study)
                                        ? "The spins are those of the load at rest, cut after n."
                                        : "Each terminal spin is a balance of its own."),
                        truncation_fields().table(shown_truncations(truncations), Face::console) } };
  return results;
}

} // namespace stemware::pipeline
