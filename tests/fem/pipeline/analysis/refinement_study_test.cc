#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_file.h"
#include "ring_model/spin/answer.h"
#include "tests/benchmark/random_study.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using Sizes = std::vector<unsigned int>;

TEST(RefinementAxes, StayWithinTheAllowedRanges)
{
  Study study = test::mat_study();
  study.contact.degree = 4;
  study.contact.refinements = 6;
  study.contact.harmonics = 20;
  study.contact.azimuth_lines = 64;
  study.contact.memory_limit = 1e15;
  const std::vector<RefinementAxis> axes = refinement_axes(study, 3);
  ASSERT_EQ(axes.size(), 4u);
  EXPECT_EQ(axes[0].sizes, (Sizes{ 5, 6 })); // at most 6 refinements
  EXPECT_EQ(axes[1].sizes, (Sizes{ 3, 4 }));
  EXPECT_EQ(axes[1].own, 1u);
  EXPECT_EQ(axes[2].sizes, (Sizes{ 10, 20 })); // 40 harmonics would need 81 lines
  EXPECT_EQ(axes[3].sizes, (Sizes{ 64, 128, 256 }));
  study.table.interface = TableInterface::hard;
  study.table.substrate = TableSubstrate::elastic;
  EXPECT_EQ(refinement_axes(study, 3)[2].sizes, (Sizes{ 10, 20 }));
  EXPECT_EQ(refinement_axes(study, 3).size(), 4u); // hard tables also have the axis of azimuth lines
}

Study much_finer(Study study)
{
  study.contact.refinements += 2;
  study.contact.harmonics *= 2;
  study.contact.azimuth_lines *= 4;
  return study;
}

BalancedLoad load_of(const Study &study, fem::ComplianceCache &cache)
{
  return find_load(study, study_foot(study, foot_maker(cache)));
}

struct Levels
{
  Levels(const Study &study, const Study &finer_study)
      : foot(study_foot(study, foot_maker(cache)))
      , load(find_load(study, foot))
      , row(ring::answer(load, question_of(study)).value())
      , omega(row.terminal->omega)
      , quick(estimate_bands({ study, foot, ThreadedExecutor(cache) }, row, std::nullopt))
      , finer(quantities_of_load(finer_study, load_of(finer_study, cache), spins_of_interest(omega), omega))
  {
  }

  const BandedQuantity &band(const std::string &key) const { return quick[index_of(quick, key)]; }

  static ring::Question question_of(const Study &study)
  {
    ring::Question question = { study.motion.orbit };
    question.with_slope = true;
    return question;
  }

  fem::ComplianceCache cache;
  std::shared_ptr<ElasticFoot> foot;
  BalancedLoad load;
  ring::Answer row;
  double omega;
  ErrorBands quick;
  std::vector<QuantityOfInterest> finer;
};

TEST(ErrorBands, ContainTheResultsOfAFinerDiscretisationAndTheConvergenceOrderIsPlausible)
{
  const Study study = read_study(STEMWARE_COOKBOOKS "/paper.prm", {});
  Levels comparison(study, four_times_finer(study));
  for (const QuantityOfInterest &finer : comparison.finer)
  {
    const BandedQuantity &banded = comparison.band(finer.key);
    EXPECT_NEAR(banded.quantity.value, finer.value, banded.band) << finer.name;
  }
  const BandedQuantity &spin = comparison.band("omega_terminal");
  EXPECT_GT(spin.band, std::abs(spin.quantity.value - quantity_of(comparison.finer, "omega_terminal").value));
  EXPECT_LT(spin.band, 1e-5); // the error band is not too wide [rad/s]

  // The command `converge` finds a convergence order between 1 (re-entrant corners) and 4 (smooth section).
  std::vector<RefinementAxis> axes = refinement_axes(study, 3);
  const ErrorBands full =
    refine(quantities_of_load(study, comparison.load, spins_of_interest(comparison.omega), comparison.omega),
           axes, ThreadedExecutor(comparison.cache));
  const double depth = std::abs(quantity_of(comparison.finer, "table_motion_0").value);
  for (const std::string key : { "table_motion_0", "table_motion_1", "table_motion_2" })
  {
    const BandedQuantity &motion = full[index_of(full, key)];
    EXPECT_NEAR(motion.quantity.value, quantity_of(comparison.finer, key).value, motion.band) << key;
    EXPECT_LT(motion.band, 1e-3 * (motion.quantity.unit == "m" ? depth : depth / 0.03)) << key;
  }
  const std::size_t index = index_of(full, "omega_terminal");
  const BandedQuantity &refined = full[index];
  const double finer = quantity_of(comparison.finer, "omega_terminal").value;
  EXPECT_NEAR(refined.quantity.value, finer, refined.band);
  EXPECT_NEAR(refined.richardson, finer, refined.band / 3);
  ASSERT_TRUE(axes[0].quantities[index].order);
  EXPECT_GT(*axes[0].quantities[index].order, 1.);
  EXPECT_LT(*axes[0].quantities[index].order, 4.);

  for (const BandedQuantity &banded : full)
  {
    const double rounding = comparison.band(banded.quantity.key).quantity.rounding;
    EXPECT_NEAR(banded.quantity.rounding, rounding, 1e-3 * rounding) << banded.quantity.key;
  }
}

void expect_band_of_spin_holds(const Study &study)
{
  const Levels comparison(study, much_finer(study));
  const BandedQuantity &spin = comparison.band("omega_terminal");
  const double finer = quantity_of(comparison.finer, "omega_terminal").value;
  EXPECT_NEAR(spin.quantity.value, finer, spin.band);
  EXPECT_LT(spin.band, 2e-3 * std::abs(spin.quantity.value));
}

// tests/benchmark/error_band_coverage.cc checks many more random studies (docs/method/error_bands.md).

TEST(ErrorBands, ContainTheSpinErrorOfARandomStudyLong)
{
  expect_band_of_spin_holds(RandomStudies(2024).next());
}

TEST(ErrorBands, ContainTheSpinErrorOfARandomStudyWithFewAzimuthLines)
{
  Study study = RandomStudies(2024).next();
  study.contact.harmonics = 8;
  study.contact.azimuth_lines = 64;
  expect_band_of_spin_holds(study);
}

/// Expects that the error band includes the error of the corners of the step. On a hard table, the contact
/// cells are so small that the corners dominate the error. An error band from the contact cells only would be
/// too narrow.
void expect_band_holds_corners(unsigned int n_harmonics, unsigned int n_lines)
{
  Study study = test::mat_study();
  study.glass.profile.shape = fem::GlassShape::step;
  study.glass.profile.crown_radius = 0.005;
  study.table.interface = TableInterface::hard;
  study.contact.harmonics = n_harmonics;
  study.contact.azimuth_lines = n_lines;
  Study finer = study;
  finer.contact.refinements = 2;
  const Levels comparison(study, finer);
  const BandedQuantity &spin = comparison.band("omega_terminal");
  const double error = std::abs(spin.quantity.value - quantity_of(comparison.finer, "omega_terminal").value);
  EXPECT_GT(error, 4e-5); // the error is significant [rad/s]
  EXPECT_LT(error, spin.parts.at("mesh"));
  EXPECT_LT(spin.parts.at("mesh"), 10 * error);
}

TEST(ErrorBands, IncludeTheErrorOfCornersFarFromTheContactLong)
{
  expect_band_holds_corners(test::mat_study().contact.harmonics, test::mat_study().contact.azimuth_lines);
}

TEST(ErrorBands, IncludeTheErrorOfCornersFarFromTheContactWithFewAzimuthLines)
{
  expect_band_holds_corners(6, 64);
}

TEST(ErrorBands, ContainTheErrorOfASingleRingAndAreAtMostTwiceAsLarge)
{
  Study study = test::mat_study();
  study.contact.rings = 1;
  study.table.foundation_modulus = 1e9; // gives a wide contact
  Study finer = study;
  finer.contact.rings = 24;
  const Levels comparison(study, finer);
  const BandedQuantity &spin = comparison.band("omega_terminal");
  const double error = std::abs(spin.quantity.value - quantity_of(comparison.finer, "omega_terminal").value);
  EXPECT_GT(error, 0.5 * spin.band);
  EXPECT_LT(error, spin.band);
}

class FootWithoutBalance : public fem::Foot
{
public:
  fem::FootDescription description() const override { return {}; }
  fem::FootCapabilities capabilities() const override { return {}; }
  fem::ContactState solve(const fem::ContactDemand &, const ring::Slip &, const fem::ContactGuess &,
                          const std::function<void(const fem::ContactIteration &)> &) const override
  {
    throw ring::NoBalance("no balance here");
  }
  unsigned int n_resolved_harmonics() const override { return 16; }
  fem::ContactLoad project_onto_rings(const fem::ContactState &, const std::vector<double> &,
                                      unsigned int) const override
  {
    throw std::logic_error("there is no contact");
  }
  std::vector<fem::PointForce> point_forces(const fem::ContactState &) const override { return {}; }
  fem::PressureMap pressure_map(const fem::ContactState &) const override { return {}; }
};

/// Just before tipping, the contact on a changed discretisation may have no moment balance.
TEST(ErrorBands, AreEmptyIfAChangedDiscretisationHasNoBalance)
{
  const test::SolvedStudy solved(test::quick_contact_study());
  const Executor executor([](const FootSpecification &, const fem::Foot *)
                          { return std::make_shared<FootWithoutBalance>(); });
  EXPECT_TRUE(estimate_bands({ solved.study, solved.foot, executor }, solved.row, std::nullopt).empty());
}

/// Budget rows with a closed form have no error band.
TEST(ErrorBands, ExistForExactlyTheBudgetRowsWithAContactAndAgreeWithTheSpinBands)
{
  Study study = test::quick_contact_study();
  study.contact.harmonics = 16;
  study.contact.azimuth_lines = 64;
  study.contact.load_harmonics = 24;
  const test::SolvedStudy solved(study);
  fem::ComplianceCache cache;
  const StudyRows answers = rows_by_harmonics({ study, solved.foot, ThreadedExecutor(cache) }, solved.load,
                                              Depth::full, model_chain({ study }));
  const ErrorBands bands = estimate_bands({ study, solved.foot, ThreadedExecutor(cache) }, solved.row,
                                          answers.by_harmonics.front().row.omega_terminal());
  const std::optional<double> all = band_of(bands, "omega_terminal"),
                              first = band_of(bands, "omega_first_harmonic");
  ASSERT_TRUE(all && first);
  const std::vector<BudgetRow> rows = assess_chain(answers, { all, first });
  ASSERT_EQ(rows.back().step.number, 11u); // rows 1, 2, 3, 3a, 4 ... 11
  for (const BudgetRow &row : rows)
    EXPECT_EQ(row.band.has_value(), row.step.number >= 3) << row.name;
  EXPECT_EQ(rows.back().band, all);
  EXPECT_EQ(rows[3].band, first); // row 3a: harmonics n <= 1 with tilt
  EXPECT_NEAR(*rows[rows.size() - 2].omega_terminal, *rows.back().omega_terminal, 1e-9);
  EXPECT_NEAR(*rows[rows.size() - 2].band, *all, 1e-9);
}

TEST(ErrorBands, OfModelsAreDerivedFromTheBandsOfTheFirstAndOfAllHarmonics)
{
  const double omega = -3.65, omega_first = -3.7;
  const auto band_at = [&](double spin, const SpinBands &bands)
  { return model_band(spin, omega, omega_first, bands); };
  const SpinBands both = { 1e-3, 3e-3 };
  for (const double spin : { omega_first, -3.6 })
    EXPECT_NEAR(band_at(spin, both).value(), 3e-3, 1e-12) << spin;
  EXPECT_NEAR(band_at(-3.6501, both).value(), 1.1e-3, 1e-12); // the band of omega plus the difference
  EXPECT_NEAR(band_at(omega, both).value(), 1e-3, 1e-12);
  EXPECT_NEAR(band_at(-3.7001, { 3e-3, 1e-3 }).value(), 1.1e-3, 1e-12);
  EXPECT_FALSE(band_at(omega_first, { 1e-3, {} }));
  EXPECT_NEAR(band_at(-3.6501, { 1e-3, {} }).value(), 1.1e-3, 1e-12);
  EXPECT_FALSE(band_at(omega, {}));
  EXPECT_FALSE(model_band(omega, {}, omega_first, both));
}

TEST(ErrorBands, MessageOfAFailedRefinementNamesTheDegree)
{
  Study study = test::mat_study();
  study.load.moment_ratio = 0.5;
  fem::ComplianceCache cache;
  const BalancedLoad load = load_of(study, cache);
  const std::vector<double> spins = { -1 };
  std::vector<RefinementAxis> axes = refinement_axes(study, 2);
  axes[1].levels.back().study.load.moment_ratio = 2.3; // the glass tips under this moment
  EXPECT_THAT([&] { refine(quantities_of_load(study, load, spins), axes, ThreadedExecutor(cache)); },
              testing::ThrowsMessage<std::runtime_error>(
                testing::AllOf(testing::HasSubstr("4"), testing::HasSubstr("degree"))));
}

} // namespace
} // namespace stemware::pipeline
