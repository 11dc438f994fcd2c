// Numbers of one case of a sweep.
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

/// Values of a study by their keys.
class SolvedCase
{
public:
  explicit SolvedCase(const Study &study)
  {
    fem::ComplianceCache cache;
    result = test::solve_case(study, ThreadedExecutor(cache));
  }
  std::optional<double> operator[](const std::string &key) const { return result.value(key); }

private:
  CaseResult result;
};

TEST(SweepCase, HasTheEffectOfHarmonicsOfTheBudget)
{
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    Study study = quick_contact_study();
    study.load.coupling = coupling;
    fem::ComplianceCache cache;
    const Budget budget = test::whole_budget(study, ThreadedExecutor(cache));
    const SolvedCase solved(study);
    EXPECT_NEAR(*solved["harmonic_effect"], *budget.harmonics.absolute, 1e-9);
    EXPECT_NEAR(*solved["harmonic_effect_relative"], *budget.harmonics.relative, 1e-9);
    EXPECT_NEAR(*solved["omega_terminal"] - *solved["omega_first_harmonic"], *solved["harmonic_effect"],
                1e-12);
  }
}

TEST(SweepCase, HasTheClosedFormsOfTheBudget)
{
  Study study = quick_contact_study();
  fem::ComplianceCache cache;
  const Budget budget = test::whole_budget(study, ThreadedExecutor(cache));
  const SolvedCase solved(study);
  EXPECT_EQ(budget.rows[0].name, "paper");
  EXPECT_NEAR(*solved["omega_paper"], *budget.rows[0].omega_terminal, 1e-9);
  EXPECT_EQ(budget.rows[1].name, "moment balance");
  EXPECT_NEAR(*solved["omega_on_ring"], *budget.rows[1].omega_terminal, 1e-9);
}

} // namespace
} // namespace stemware::pipeline
