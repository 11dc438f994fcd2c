#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/analysis/variant.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace stemware::pipeline
{

namespace
{

using namespace stemware::test;

/// Returns the spins of the budget, the spins without each effect and on one ring, and the error bands; 0 for
/// a missing spin.
std::vector<double> results_on(unsigned int n_threads)
{
  const SolvedStudy solved(quick_contact_study());
  fem::ComplianceCache cache;
  const ThreadedExecutor executor(cache, n_threads);
  const SpinStudy spin = study_spin({ solved.study, solved.foot, executor }, solved.load);
  std::vector<double> digits = { spin.one_ring->omega_terminal().value_or(0) };
  const Budget budget = find_budget(spin.rows);
  for (const BudgetRow &row : budget.rows)
    digits.push_back(row.omega_terminal.value_or(0));
  for (const WithoutRow &row : budget.without)
    digits.push_back(row.omega_terminal.value_or(0));
  for (const BandedQuantity &banded :
       estimate_bands({ solved.study, solved.foot, executor }, spin.answer(), std::nullopt))
    digits.push_back(banded.band);
  return digits;
}

TEST(Solve, ResultsDoNotDependOnTheNumberOfThreads)
{
  const std::vector<double> one = results_on(1);
  EXPECT_GT(one.size(), 30u);
  for (const unsigned int n_threads : { 2u, 4u })
    EXPECT_EQ(results_on(n_threads), one) << n_threads;
}

TEST(Solve, ResultsDoNotDependOnTheOrderOfTheVariants)
{
  const SolvedStudy solved(quick_contact_study());
  std::vector<Variant> variants = variants_without({ solved.foot->specification() });
  for (const Variant &model : model_chain({ solved.study }))
    variants.push_back(model);
  fem::ComplianceCache cache;
  const std::vector<LoadedRow> rows = solve_rows(variants, solved.foot, {}, ThreadedExecutor(cache));
  std::reverse(variants.begin(), variants.end());
  const std::vector<LoadedRow> reversed = solve_rows(variants, solved.foot, {}, ThreadedExecutor(cache));
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].row.omega_terminal(), reversed[rows.size() - 1 - i].row.omega_terminal())
      << variants[rows.size() - 1 - i].name;
}

TEST(Solve, AFailedVariantGivesItsReasonAndTheOthersContinue)
{
  const Study study = quick_contact_study();
  std::vector<Variant> variants(3, { { study } });
  variants[0].reason = "not defined";
  variants[1].study.load.moment_ratio = 2.3;
  std::vector<std::size_t> done;
  fem::ComplianceCache cache;
  const auto solved = solve(
    variants, nullptr,
    [](const Variant &, const std::shared_ptr<ElasticFoot> &foot) { return foot->radius(); },
    ThreadedExecutor(cache), [&](std::size_t i, const auto &) { done.push_back(i); });
  EXPECT_EQ(done, (std::vector<std::size_t>{ 0, 1, 2 }));
  EXPECT_EQ(failed_row(solved[0].failure).reason, "not defined");
  EXPECT_EQ(failed_row(solved[1].failure).status, ring::Status::tips);
  EXPECT_EQ(solved[2].value(), study.glass.profile.contact_radius);
}

TEST(Solve, FailuresAreStoredPerVariantOrThrownAtOnce)
{
  const std::vector<Variant> variants(2, { { quick_contact_study() } });
  const auto question = [](const Variant &, const std::shared_ptr<ElasticFoot> &) -> int
  { throw std::logic_error("a bug"); };
  const auto no_callback = [](std::size_t, const auto &) {};
  fem::ComplianceCache cache;
  ThreadedExecutor executor(cache);
  EXPECT_THROW(solve(variants, nullptr, question, executor, no_callback)[1].value(), std::logic_error);
  executor.keeps_all_failures = false;
  EXPECT_THROW(solve(variants, nullptr, question, executor, no_callback), std::logic_error);
}

} // namespace

} // namespace stemware::pipeline
