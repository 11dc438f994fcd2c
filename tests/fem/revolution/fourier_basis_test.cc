#include "fem/revolution/fourier_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace stemware::fem;

TEST(FourierBasis, ValuesAreTheTrigonometricFunctions)
{
  const FourierBasis basis(5, 24);
  for (unsigned int j = 0; j < basis.n_lines(); ++j)
    for (unsigned int mode = 0; mode < basis.n_modes(); ++mode)
    {
      const double angle = FourierBasis::harmonic(mode) * basis.azimuth(j);
      const bool sine = FourierBasis::is_sine(mode);
      EXPECT_NEAR(basis.values()(j, mode), sine ? std::sin(angle) : std::cos(angle), 1e-14);
      EXPECT_NEAR(basis.conjugates()(j, mode), sine ? -std::cos(angle) : std::sin(angle), 1e-14);
    }
}

TEST(FourierBasis, ProductsAreTheSumsOverTheLines)
{
  const FourierBasis basis(4, 16); // products reach beyond the highest harmonic that the lines tell apart
  const Eigen::MatrixXd samples = Eigen::MatrixXd::Random(2, 16);
  const FourierProducts products(basis, samples, true);
  for (unsigned int row = 0; row < basis.n_modes(); ++row)
    for (unsigned int column = 0; column < basis.n_modes(); ++column)
      for (Eigen::Index f = 0; f < 2; ++f)
      {
        double sum = 0;
        double partner_sum = 0;
        for (unsigned int j = 0; j < 16; ++j)
        {
          sum += samples(f, j) * basis.values()(j, row) * basis.values()(j, column);
          partner_sum += samples(f, j) * basis.conjugates()(j, row) * basis.values()(j, column);
        }
        EXPECT_NEAR(products(row, column)(f), sum, 1e-13) << row << ", " << column;
        EXPECT_NEAR(products.with_conjugate(row, column)(f), partner_sum, 1e-13) << row << ", " << column;
      }
}

namespace
{
/// Lines whose halves meet at a line of their own, and lines that pass theta = pi on either side.
constexpr unsigned int numbers_of_lines[] = { 16, 17 };
} // namespace

TEST(FourierBasis, ProjectsAndEvaluatesLikeTheTablesOfItsModes)
{
  for (const unsigned int n_lines : numbers_of_lines)
  {
    const FourierBasis basis(4, n_lines);
    const Eigen::MatrixXd samples = Eigen::MatrixXd::Random(3, n_lines);
    const Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Random(3, basis.n_modes());
    EXPECT_LT((basis.project(samples) - samples * basis.values()).norm(), 1e-13);
    EXPECT_LT((basis.project_on_conjugates(samples) - samples * basis.conjugates()).norm(), 1e-13);
    EXPECT_LT((basis.evaluate(amplitudes) - amplitudes * basis.values().transpose()).norm(), 1e-13);
  }
}

TEST(FourierBasis, KeepsMirrorSymmetryToTheLastBit)
{
  for (const unsigned int n_lines : numbers_of_lines)
  {
    const FourierBasis basis(4, n_lines);
    Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Random(3, basis.n_modes());
    for (unsigned int mode = 2; mode < basis.n_modes(); mode += 2)
      amplitudes.col(mode).setZero();
    const Eigen::MatrixXd even = basis.evaluate(amplitudes);
    for (unsigned int line = 1; line < n_lines; ++line)
      EXPECT_EQ(even.col(line), even.col(n_lines - line)) << "line " << line << " of " << n_lines;
    const Eigen::MatrixXd projected = basis.project(even);
    for (unsigned int mode = 2; mode < basis.n_modes(); mode += 2)
      EXPECT_TRUE((projected.col(mode).array() == 0).all()) << "mode " << mode;
  }
}

TEST(FourierBasis, RefusesTooFewLines)
{
  EXPECT_THROW(FourierBasis(8, 16), std::invalid_argument);
  EXPECT_THROW(FourierBasis(0, 16), std::invalid_argument);
  EXPECT_NO_THROW(FourierBasis(8, 17));
}
