#include "fem/revolution/fourier_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace stemware::fem;

namespace
{
/// Values of the modes on the lines, or of their conjugates, shape [n_lines, n_modes].
Eigen::MatrixXd mode_table(const FourierBasis &basis, bool of_conjugates)
{
  Eigen::MatrixXd table(basis.n_lines(), basis.n_modes());
  for (unsigned int j = 0; j < basis.n_lines(); ++j)
    for (unsigned int mode = 0; mode < basis.n_modes(); ++mode)
    {
      const double angle = FourierBasis::harmonic(mode) * basis.azimuth(j);
      const bool sine = FourierBasis::is_sine(mode);
      table(j, mode) = sine != of_conjugates ? std::sin(angle) : (of_conjugates ? -1 : 1) * std::cos(angle);
    }
  return table;
}
} // namespace

TEST(FourierBasis, ProjectsAndEvaluatesLikeTheTablesOfItsModes)
{
  // Lines whose halves meet at a line of their own, and lines that pass theta = pi on either side.
  for (const unsigned int n_lines : { 16u, 17u })
  {
    const FourierBasis basis(4, n_lines);
    const Eigen::MatrixXd samples = Eigen::MatrixXd::Random(3, n_lines);
    const Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Random(3, basis.n_modes());
    EXPECT_LT((basis.project(samples) - samples * mode_table(basis, false)).norm(), 1e-13);
    EXPECT_LT((basis.project_on_conjugates(samples) - samples * mode_table(basis, true)).norm(), 1e-13);
    EXPECT_LT((basis.evaluate(amplitudes) - amplitudes * mode_table(basis, false).transpose()).norm(), 1e-13);
    EXPECT_LT(
      (basis.evaluate_conjugates(amplitudes) - amplitudes * mode_table(basis, true).transpose()).norm(),
      1e-13);
  }
}

TEST(FourierBasis, RefusesTooFewLines)
{
  EXPECT_THROW(FourierBasis(8, 16), std::invalid_argument);
  EXPECT_THROW(FourierBasis(0, 16), std::invalid_argument);
  EXPECT_NO_THROW(FourierBasis(8, 17));
}
