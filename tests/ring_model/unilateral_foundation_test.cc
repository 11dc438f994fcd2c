#include "ring_model/load/constants.h"
#include "tests/ring_model/reference.h"
#include "tests/ring_model/unilateral_rim.h"

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

void expect_reference_rows(const char *table, double exponent)
{
  const test::UnilateralFoundation foundation(0.03, exponent, 16);
  for (const auto &row : reference()[table]["rows"])
  {
    const double m = row["ratio"];
    const std::string name = std::string(table) + " m " + std::to_string(m);
    expect_relative(foundation.edge(m), row["c"], 1e-12, name + " edge");
    EXPECT_EQ(foundation.edge(m) <= -1., row["full_contact"].get<bool>()) << name;
    EXPECT_NEAR(std::acos(std::max(-1., foundation.edge(m))), row["theta_c"].get<double>(), 1e-12) << name;
    const auto shape = foundation.shape(m);
    for (std::size_t n = 0; n < shape.size(); ++n)
      EXPECT_NEAR(shape[n], row["a_over_a0"][n].get<double>(), 2e-13) << name << " n " << n;
  }
}

TEST(UnilateralFoundation, LinearMatRowsOfTheReference)
{
  expect_reference_rows("contact_winkler_linear", 1.);
}

TEST(UnilateralFoundation, TorusRimRowsOfTheReference)
{
  expect_reference_rows("contact_torus_winkler", 1.5);
}

TEST(UnilateralFoundation, LiftsOffAtItsOnset)
{
  for (const double p : { 0.5, 1., 1.5, 2., 3.7 })
  {
    const test::UnilateralFoundation foundation(0.03, p, 8);
    const double onset = foundation.lift_off_ratio();
    EXPECT_DOUBLE_EQ(onset, 2. * p / (p + 1.));
    EXPECT_EQ(foundation.edge(onset), -1.);
    EXPECT_LT(foundation.edge(0.9 * onset), -1.);
    EXPECT_GT(foundation.edge(onset + 0.1 * (2. - onset)), -1.);
    // a_n/a_0 = 2 Gamma(p+1)^2 / (Gamma(p+1+n) Gamma(p+1-n)) at the onset, reached from both sides.
    const double a2 = 2. * p * (p - 1.) / ((p + 1.) * (p + 2.));
    EXPECT_NEAR(foundation.shape(onset)[2], a2, 1e-14) << p;
    EXPECT_NEAR(foundation.shape(onset * (1. - 1e-9))[2], a2, 1e-7) << p;
    EXPECT_NEAR(foundation.shape(onset * (1. + 1e-9))[2], a2, 1e-7) << p;
  }
}

TEST(UnilateralFoundation, CoefficientsAreThoseOfThePointwiseLoad)
{
  // Trapezoidal rule on the pointwise load: an independent projection.
  const double p = 2.5;
  const test::UnilateralFoundation foundation(0.03, p, 12);
  for (const double m : { 0.3, 1., 1.42, 1.428, 1.4285, 1.44, 1.7, 1.95 }) // onset at 10/7
  {
    const auto shape = foundation.shape(m);
    EXPECT_NEAR(shape[1], m, 1e-12); // a_1 / a_0
    const unsigned int n_points = 20000;
    std::vector<double> load(n_points);
    const double c = foundation.edge(m);
    double mean = 0.;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      load[i] = std::pow(std::max(0., std::cos(2. * pi * i / n_points) - c), p);
      mean += load[i] / n_points;
    }
    for (unsigned int n = 0; n <= 12; ++n)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < n_points; ++i)
        sum += load[i] * std::cos(2. * pi * i * n / n_points);
      EXPECT_NEAR(shape[n], sum * (n == 0 ? 1. : 2.) / n_points / mean, 1e-11) << m << " " << n;
    }
  }
}

TEST(UnilateralFoundation, ApproachesTippingAsAPointLoad)
{
  // m = 2 - theta_c^2 / (2p+3), a_n/a_0 -> 2
  for (const double p : { 1., 1.5 })
  {
    const test::UnilateralFoundation foundation(0.03, p, 8);
    const double m = 2. - 1e-6;
    expect_relative(std::acos(foundation.edge(m)), std::sqrt((2. * p + 3.) * 1e-6), 1e-3, "edge angle");
    for (unsigned int n = 2; n <= 8; ++n)
      EXPECT_NEAR(foundation.shape(m)[n], 2., 1e-4);
  }
}
} // namespace
} // namespace stemware::ring
