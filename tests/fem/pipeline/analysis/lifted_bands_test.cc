// Error bands with lift-off and on flat lands. Reference: quadrature up to the contact edges by independent
// code (tests/verification/plain_lifted_foot.h).
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/verification/lifted_annulus.h"
#include "tests/verification/plain_lifted_foot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;
using verification::LiftedFoot;
using verification::LiftedGlass;

struct LiftedState
{
  double moment_ratio = 0, direction = 0; ///< moment ratio [1], direction [rad]
  double height = 0;                      ///< height of the centre of mass [m]; 0: given moment

  Study study() const
  {
    Study study = test::mat_study();
    if (moment_ratio > 0)
    {
      study.load.moment_ratio = moment_ratio;
      study.load.moment_direction = direction;
    }
    else
      study.motion.orbit.centre_of_mass_height = height;
    return study;
  }

  LiftedGlass glass(LiftedFoot::Friction part) const
  {
    LiftedFoot foot;
    if (moment_ratio > 0)
      return { foot, moment_ratio, direction, part };
    foot.centre_of_mass_height = height;
    return LiftedGlass(foot, part);
  }
};

/// Maximum height of the centre of mass at which a terminal spin exists [m], by independent code.
constexpr double largest_height = 0.134575746;

/// Ratios of the error to the error band, by quantity.
class Ratios
{
public:
  void add(const LiftedState &state)
  {
    const Study study = state.study();
    SolvedStudy solved(study, test::rigid_foot());
    const BalancedLoad first = find_load(study, solved.foot, silent_progress(), 1);
    const std::optional<double> omega_first =
      ring::answer(first, spin_question(study)).value().omega_terminal();
    const ErrorBands bands =
      estimate_bands({ study, solved.foot, ThreadedExecutor(solved.cache) }, solved.row, omega_first);
    ASSERT_FALSE(bands.empty());
    const std::map<std::string, double> truth = truth_of(state, solved.omega(), omega_first);
    for (const BandedQuantity &banded : bands)
      if (const auto found = truth.find(banded.quantity.key); found != truth.end())
      {
        const double error = std::abs(banded.quantity.value - found->second);
        EXPECT_LE(error, banded.band) << banded.quantity.key << " " << banded.quantity.value << ", right "
                                      << found->second << ", m = " << state.moment_ratio << ", direction "
                                      << state.direction << ", height " << state.height;
        if (banded.band > 10 * banded.quantity.rounding)
          ratios[banded.quantity.key].push_back(error / banded.band);
      }
  }

  /// Prints the worst and the median ratio of each quantity. Expects a median of all ratios between 0.1
  /// (error bands not too wide) and 0.5 (not too narrow).
  void expect_fair_medians() const
  {
    std::vector<double> all;
    for (auto [key, values] : ratios)
    {
      std::sort(values.begin(), values.end());
      std::printf("%-22s %3zu  worst %.3f  median %.3f\n", key.c_str(), values.size(), values.back(),
                  values[values.size() / 2]);
      all.insert(all.end(), values.begin(), values.end());
    }
    ASSERT_FALSE(all.empty()) << "no quantity has a reference";
    std::sort(all.begin(), all.end());
    const double median = all[all.size() / 2];
    std::printf("%-22s %3zu  worst %.3f  median %.3f\n", "all", all.size(), all.back(), median);
    EXPECT_GT(median, 0.1);
    EXPECT_LT(median, 0.5);
  }

private:
  static std::map<std::string, double> truth_of(const LiftedState &state, double omega,
                                                const std::optional<double> &omega_first)
  {
    LiftedGlass glass = state.glass(LiftedFoot::Friction::whole);
    const LiftedFoot foot = glass.foot;
    const LiftedFoot::Contact at_rest(foot, glass.position_at_rest());
    std::map<std::string, double> truth = { { "contact_fraction", at_rest.azimuth_share() },
                                            { "azimuth_fraction", at_rest.azimuth_share() },
                                            { "peak_pressure", at_rest.largest_pressure() },
                                            { "least_load", at_rest.line_load(ring::pi) } };
    for (unsigned int n = 1; n <= 6; ++n)
    {
      truth["a" + std::to_string(n)] = at_rest.harmonic(n, false);
      truth["b" + std::to_string(n)] = at_rest.harmonic(n, true);
    }
    constexpr double reach = 2e-3; // half-width of the search interval, relative to the program's spin
    const auto near = [&](LiftedGlass &of, double spin)
    { return of.terminal_spin((1 - reach) * spin, (1 + reach) * spin); };
    truth["omega_terminal"] = near(glass, omega);
    truth["time_constant"] = glass.time_constant(truth["omega_terminal"], 0.003);
    if (omega_first)
    {
      LiftedGlass of_first = state.glass(LiftedFoot::Friction::first_harmonic);
      truth["omega_first_harmonic"] = near(of_first, *omega_first);
      truth["harmonic_effect"] = truth["omega_terminal"] - truth["omega_first_harmonic"];
    }
    return truth;
  }

  std::map<std::string, std::vector<double>> ratios;
};

double uniform(std::mt19937 &random, double from, double to)
{
  return from + (to - from) * static_cast<double>(random()) / 4294967296.;
}

LiftedState random_moment(std::mt19937 &random)
{
  const double ratio = uniform(random, 1.21, 1.96);
  return { ratio, uniform(random, -2.2, -0.9) };
}

LiftedState random_height(std::mt19937 &random)
{
  return { 0, 0, uniform(random, 0.109, 0.134) };
}

void expect_bands_hold(LiftedState (*draw)(std::mt19937 &), unsigned int seed, unsigned int n_states)
{
  std::mt19937 random(seed);
  Ratios ratios;
  for (unsigned int i = 0; i < n_states; ++i)
    ratios.add(draw(random));
  ratios.expect_fair_medians();
}

void expect_bands_hold_up_to_tipping(unsigned int n_steps)
{
  Ratios ratios;
  for (unsigned int i = 0; i <= n_steps; ++i)
  {
    LiftedState state;
    state.height = 0.1340 + 0.0012 * i / n_steps;
    if (state.height < largest_height)
      ratios.add(state);
    else
      EXPECT_FALSE(SolvedStudy(state.study()).row.terminal) << state.height;
  }
  ratios.expect_fair_medians();
}

TEST(LiftedBands, ContainTheErrorUnderRandomMomentsLong)
{
  expect_bands_hold(random_moment, 42, 30);
}

TEST(LiftedBands, ContainTheErrorUnderTwoRandomMoments)
{
  expect_bands_hold(random_moment, 42, 2);
}

TEST(LiftedBands, ContainTheErrorAtRandomCentreOfMassHeightsLong)
{
  expect_bands_hold(random_height, 43, 20);
}

TEST(LiftedBands, ContainTheErrorAtTwoRandomCentreOfMassHeights)
{
  expect_bands_hold(random_height, 43, 2);
}

TEST(LiftedBands, ContainTheErrorUpToTheTippingHeightAndNoSpinExistsAboveItLong)
{
  expect_bands_hold_up_to_tipping(20);
}

TEST(LiftedBands, ContainTheErrorBelowTheTippingHeightAndNoSpinExistsAboveIt)
{
  expect_bands_hold_up_to_tipping(1);
}

/// Expects that the error bands contain the error in states whose slip vanishes inside the contact at the
/// terminal spin. In these states, the spin converges slowly with the number of rings. The moment ratios
/// increase from @p smallest_moment in steps of 0.01.
void expect_bands_with_vanishing_slip_hold(double smallest_moment, unsigned int n_states)
{
  Ratios ratios;
  for (unsigned int i = 0; i < n_states; ++i)
  {
    LiftedState state;
    state.moment_ratio = smallest_moment + 0.01 * i;
    state.direction = -ring::pi / 2;
    ratios.add(state);
  }
  ratios.expect_fair_medians();
}

TEST(LiftedBands, ContainTheErrorIfTheSlipVanishesInTheContactLong)
{
  expect_bands_with_vanishing_slip_hold(1.90, 9);
}

TEST(LiftedBands, ContainTheErrorAtOneMomentRatioWithVanishingSlip)
{
  expect_bands_with_vanishing_slip_hold(1.95, 1);
}

// Rigid flat lands. References: closed forms on a mat; tests/verification/annular_punch.py for an annular
// punch on a bonded elastic layer.

Study flat_study(double width, double moment_ratio, double direction)
{
  Study study = test::mat_study();
  study.glass.profile.crown_radius = 0;
  study.glass.profile.land_width = width;
  study.glass.profile.foot_radius = study.glass.profile.contact_radius + width;
  study.load.moment_ratio = moment_ratio;
  study.load.moment_direction = direction;
  study.contact.friction_coupling = FrictionCoupling::none;
  return study;
}

void expect_within_bands(const Study &study, const std::map<std::string, double> &expected, double widest)
{
  const test::SolvedStudy solved(study, test::rigid_foot());
  fem::ComplianceCache cache;
  const ErrorBands bands =
    estimate_bands({ study, solved.foot, ThreadedExecutor(cache) }, solved.row, std::nullopt);
  for (const auto &[key, value] : expected)
  {
    const auto found = find_quantity(bands, key);
    ASSERT_NE(found, bands.end()) << key;
    const double error = std::abs(found->quantity.value - value);
    EXPECT_LE(error, found->band) << key << ", width " << study.glass.profile.land_width;
    EXPECT_LT(found->band, widest * std::abs(value)) << key;
  }
}

TEST(FlatLandBands, ContainTheErrorWithLiftOffOnAMat)
{
  struct Row
  {
    double width, moment_ratio, direction;
  };
  for (const Row &row :
       { Row{ 0.004, 1.1, -1.3 }, Row{ 0.004, 1.3, -1.9 }, Row{ 0.010, 1.3, 0.4 }, Row{ 0.020, 1.2, -0.7 } })
  {
    Study study = flat_study(row.width, row.moment_ratio, row.direction);
    study.table.foundation_modulus = 1e9;
    const double radius = study.glass.profile.contact_radius, outer = radius + row.width / 2;
    const verification::LiftedAnnulus exact(radius - row.width / 2, outer, row.moment_ratio * radius / 2);
    const double slope = study.motion.orbit.normal_force() / exact.per_slope, tilt = -slope / 1e9;
    // The pressure vanishes on the line x = exact.zero. An azimuth is in contact if its outermost point (zero
    // > 0) or its innermost point (zero < 0) is in contact.
    const double last = exact.zero < 0 ? radius - row.width / 2 : outer;
    expect_within_bands(study,
                        { { "contact_fraction", exact.share },
                          { "azimuth_fraction", std::acos(std::max(-1., exact.zero / last)) / ring::pi },
                          { "peak_pressure", slope * (outer - exact.zero) },
                          { "table_motion_0", -tilt * exact.zero },
                          { "table_motion_1", tilt * std::cos(row.direction) },
                          { "table_motion_2", tilt * std::sin(row.direction) } },
                        0.02);
  }
}

TEST(FlatLandBands, ContainTheErrorOfPunchesOnHardLayers)
{
  struct Row
  {
    /// Layer thickness [m]; load P/(2 E* a delta) [1]; moment 3 M/(4 E* a^3 alpha) [1]. Outer radius a,
    /// indentation delta, tilt alpha.
    double thickness, load, moment;
  };
  for (const Row &row : { Row{ 3, 0.904734120, 0.940845472 }, Row{ 0.005, 5.084536833, 3.147039011 } })
  {
    const double outer = 0.030, direction = -1.2;
    Study study = flat_study(0.006, 0.2, direction);
    study.glass.profile.contact_radius = 0.027;
    study.table.interface = TableInterface::hard;
    study.table.substrate = TableSubstrate::elastic;
    study.table.disc.thickness = row.thickness;
    study.table.disc.radius = 3;
    const double modulus =
      study.table.disc_material.young_modulus / (1 - std::pow(study.table.disc_material.poisson_ratio, 2));
    const double force = study.motion.orbit.normal_force(), moment = 0.2 * force * 0.027 / 2;
    const double tilt = -3 * moment / (4 * modulus * std::pow(outer, 3) * row.moment);
    expect_within_bands(study,
                        { { "table_motion_0", -force / (2 * modulus * outer * row.load) },
                          { "table_motion_1", tilt * std::cos(direction) },
                          { "table_motion_2", tilt * std::sin(direction) } },
                        0.1);
  }
}

} // namespace
} // namespace stemware::pipeline
