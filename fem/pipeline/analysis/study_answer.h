#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/goal_mesh.h"
#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"

#include <memory>
#include <optional>
#include <vector>

/// One function for each question about a study, shared by the program's verbs and Python.
namespace stemware::pipeline
{

/// Study and its answer; members that a verb does not compute are empty.
struct StudyAnswer
{
  Study study = {};
  std::optional<GoalOutcome> goal = {};
  ContactReport contact = {};
  SpinStudy spin = {};
  ErrorBands bands = {};             ///< empty without Depth::full, and if not estimated
  std::optional<Budget> budget = {}; ///< std::nullopt without Depth::full
  FieldReport fields = {};
};

/// Answers the checked @p study. @p with_fields: also fields and stressed section; @p start as in
/// case_result(). Collective if the body is. Throws BadInput, fem::ContactFailure, ring::NoBalance.
StudyAnswer answer_study(const Study &study, Depth depth, const Executor &executor, bool with_fields,
                         std::shared_ptr<ElasticFoot> *start = nullptr);

/// Answers the study of @p analysis on its foot. @p goal: outcome of mesh_for_goal(), for StudyAnswer::goal.
/// Otherwise as above.
StudyAnswer answer_study(const Analysis &analysis, Depth depth, bool with_fields = false,
                         const std::optional<GoalOutcome> &goal = {});

/// Returns the quantities of torque and spin: with a description, in "ring" of summary.json.
const Fields<StudyAnswer> &study_quantities();

/// Returns study_quantities() and load_fields() at rest: with a description of the column, columns of
/// sweep.csv in this order; with a heading, in the table of ranges of a sweep; with a name in bands,
/// the name of an error band.
const Fields<StudyAnswer> &all_quantities();

/// Solves @p study on the levels of @p axes, refinement_axes(). Throws as answer_study() and refine().
ErrorBands converge_study(const Study &study, std::vector<RefinementAxis> &axes, const Executor &executor);

} // namespace stemware::pipeline
