#include "ring_model/load/constants.h"
#include "tests/ring_model/reference.h"
#include "tests/ring_model/unilateral_rim.h"

namespace stemware::ring
{
namespace
{

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

TEST(UnilateralFoundation, AgreesWithTheReferenceOnALinearMat)
{
  expect_reference_rows("contact_winkler_linear", 1.);
}

TEST(UnilateralFoundation, AgreesWithTheReferenceForATorusRim)
{
  expect_reference_rows("contact_torus_winkler", 1.5);
}

} // namespace
} // namespace stemware::ring
