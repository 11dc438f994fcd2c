#include "fem/pipeline/report/truncation_results.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all, which
/// is the last of @p rows.
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

} // namespace

Results tabulate_truncations(const Study &study, const LoadReport &load, const std::vector<SpinRow> &rows)
{
  const SpinRow &first = rows.front(), &all = rows.back();
  const double omega = all.omega_terminal().value();
  const HarmonicEffect effect = harmonic_effect(first.omega_terminal(), omega, spin_scale(study));
  const unsigned int n_enough = harmonics_enough(rows, 1e-4);
  const bool is_spinning = is_spin(study, omega);
  const std::string held = is_spinning ? "" : held_by_the_grip(study, all);
  Json reasons = Json::array();
  for (const SpinRow &row : rows)
    if (!row.reason.empty())
      reasons.push_back({ { "harmonics", row.harmonics }, { "reason", row.reason } });

  Document document;
  document.findings.summary = { { "load", load_summary(load) },
                                { "harmonic_effect", harmonic_effect_summary(effect) } };
  document.findings.key_figures = { { "omega_terminal", omega },
                                    { "harmonic_effect", effect.absolute },
                                    { "harmonic_effect_relative", effect.relative },
                                    { "harmonics_for_1e-4", n_enough } };
  document.facts = study_facts(study);
  document.facts.update({ { "held", held },
                          { "stays", !is_spinning && held.empty() },
                          { "one_harmonic", is_spinning && all.harmonics == 1 },
                          { "several_harmonics", is_spinning && all.harmonics > 1 },
                          { "omega", omega },
                          { "n_harmonics", all.harmonics },
                          { "first", first.omega_terminal() },
                          { "effect", effect_facts(study, effect) },
                          { "n_enough", n_enough },
                          { "reasons", reasons } });
  add_study(study, { { "all harmonics", omega }, { "the first alone", first.omega_terminal() } }, document,
            load.rings);
  add_truncations(rows, std::nullopt, document);
  return shown(document, "truncate");
}

} // namespace stemware::pipeline
