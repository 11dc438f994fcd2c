// Reference: Hertz line contact at the maximum line load (Johnson, Contact Mechanics, 1985, section 4.2).
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;

double value_between(std::mt19937 &random, double from, double to)
{
  return from + (to - from) * static_cast<double>(random()) / 4294967296.;
}

double log_uniform(std::mt19937 &random, double from, double to)
{
  return std::exp(value_between(random, std::log(from), std::log(to)));
}

/// Returns a random study of a glass on a rigid table or on a thick disc, which is stiffer or softer than the
/// glass. A third of these studies has lift-off.
Study random_hard_study(std::mt19937 &random)
{
  Study study = test::mat_study();
  study.motion.orbit.mass = log_uniform(random, 0.1, 0.8);
  study.glass.material = { log_uniform(random, 5e10, 2e11), value_between(random, 0.15, 0.35) };
  study.glass.profile.crown_radius = log_uniform(random, 1e-3, 1e-2);
  study.load.moment_ratio = value_between(random, 0, 1.5);
  study.load.moment_direction = value_between(random, -3, 3);
  study.table.interface = TableInterface::hard;
  if (value_between(random, 0, 1) < 0.7)
  {
    study.table.substrate = TableSubstrate::elastic;
    study.table.disc = { 0.15, 0.05 };
    study.table.disc_material = { log_uniform(random, 5e9, 2e11), value_between(random, 0.1, 0.4) };
  }
  study.contact.harmonics = 8;
  study.contact.azimuth_lines = 64;
  study.contact.friction_coupling = FrictionCoupling::none;
  return study;
}

/// Hertz line contact of the rim of @p study under @p line_load [N/m].
struct LineContact
{
  LineContact(const Study &study, double line_load)
  {
    const auto compliance = [](const fem::ElasticMaterial &material)
    { return (1 - material.poisson_ratio * material.poisson_ratio) / material.young_modulus; };
    double sum = compliance(study.glass.material);
    if (study.table.substrate == TableSubstrate::elastic)
      sum += compliance(study.table.disc_material);
    half_width = std::sqrt(4 * line_load * study.glass.profile.crown_radius * sum / ring::pi);
    peak = 2 * line_load / (ring::pi * half_width);
  }

  double half_width, peak; ///< half-width [m], peak pressure [Pa]
};

void expect_pressures_of_random_rims(unsigned int n_studies, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<double> errors, bands_over_values;
  for (unsigned int i = 0; i < n_studies; ++i)
  {
    const Study study = random_hard_study(random);
    SolvedStudy solved(study);
    const LoadReport &report = solved.load.report();
    double largest = 0;
    for (const fem::AzimuthValue &place : report.pointwise)
      largest = std::max(largest, place.value);
    const LineContact hertz(study, largest / study.glass.profile.contact_radius);
    const ErrorBands bands =
      estimate_bands({ study, solved.foot, ThreadedExecutor(solved.cache) }, solved.row, {});
    ASSERT_FALSE(bands.empty()) << i;
    for (const auto &[key, right] :
         { std::pair("peak_pressure", hertz.peak), { "contact_width", 2 * hertz.half_width } })
    {
      const BandedQuantity &banded = bands[index_of(bands, key)];
      const double value = banded.quantity.value, band = banded.band;
      // If the maximum line load lies between two azimuth lines, value and reference differ by up to 5e-4
      // (relative).
      EXPECT_LE(std::abs(value - right), band + 5e-4 * right)
        << key << " of study " << i << ": " << value << ", Hertz " << right << ", m "
        << study.load.moment_ratio;
      EXPECT_LT(band, 0.1 * value) << key << " of study " << i;
      errors.push_back(std::abs(value / right - 1));
      bands_over_values.push_back(band / value);
    }
  }
  for (std::vector<double> *list : { &errors, &bands_over_values })
  {
    std::sort(list->begin(), list->end());
    std::printf("%s: median %.2g, worst %.2g\n", list == &errors ? "errors" : "bands",
                (*list)[list->size() / 2], list->back());
  }
}

TEST(HardPressure, AgreesWithHertzOnThreeRandomRims)
{
  expect_pressures_of_random_rims(3, 1);
}

TEST(HardPressure, AgreesWithHertzOnSixtyRandomRimsLong)
{
  expect_pressures_of_random_rims(60, 2);
}

} // namespace
} // namespace stemware::pipeline
