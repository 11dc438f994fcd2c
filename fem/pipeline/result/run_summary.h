#pragma once

#include "fem/pipeline/analysis/goal_mesh.h"
#include "fem/pipeline/result/common_sections.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Everything that the summary of `run` is read from.
struct RunRow
{
  const Study &study;
  const ContactReport &report;
  const SpinStudy &spin;
  const ErrorBands &bands;
  const std::optional<GoalOutcome> &goal;

  HarmonicsRow harmonics() const
  {
    return { report.load, spin.budget.harmonics,
             truncations_of(spin.rows, spin.torque_effects, spin_scale(study)) };
  }
  AnsweredStudy answered() const
  {
    const auto &foot = report.foot;
    return { study,
             report.load,
             foot ? std::optional(foot->at_rest.solution.n_iterations) : std::nullopt,
             spin.rows.front(),
             spin.all(),
             spin.torque_effects };
  }
};

/// Returns the summary of `run`.
const Fields<RunRow> &run_fields();

/// Returns the numbers of the contact that the page shows, one column each.
Table contact_list(const FootReport &foot);

} // namespace stemware::pipeline
