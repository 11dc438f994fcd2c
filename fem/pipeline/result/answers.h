#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/case_list.h"
#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/base/json.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/torque_effect.h"

#include <optional>
#include <string>
#include <vector>

/// Answers of the verbs beside `run`.
namespace stemware::pipeline
{

/// Returns the answer of `truncate`: effect of the harmonics on the terminal spin of @p rows (last row: all
/// harmonics), or the fall of the last row. @p n_enough harmonics give the spin to 1e-4.
std::string truncation_answer(const Study &study, const std::vector<ring::Answer> &rows,
                              const ring::TorqueEffects &effects, const HarmonicEffect &effect,
                              unsigned int n_enough);

/// Returns the answer of `converge`: terminal spin with its band, the observed order on the first axis, and
/// the Richardson value.
std::string convergence_answer(const BandedQuantity &spin, const std::string &first_axis,
                               const std::optional<double> &order);

/// Smallest and largest value of a quantity of a sweep, and the cases that have them.
struct CaseRange
{
  std::size_t n = 0; ///< cases with a value
  double min = 0, max = 0;
  std::string min_case = {}, max_case = {}; ///< both "all n cases" if the value is the same to 1e-9
};

/// Returns the range of the quantity @p key without formal cases; std::nullopt if no case has a value.
std::optional<CaseRange> range_of(const CaseList &list, const FinishedCases &finished,
                                  const std::string &key);

/// Returns the answer of `sweep`: ranges of the terminal spin and of the harmonic effect; numbers of cases
/// that tip or failed.
std::string sweep_answer(const CaseList &list, const FinishedCases &finished);

} // namespace stemware::pipeline
