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

TEST(FourierBasis, ValuesAreTheTrigonometricFunctions)
{
  const FourierBasis basis(5, 24);
  const Eigen::MatrixXd each = Eigen::MatrixXd::Identity(basis.n_modes(), basis.n_modes());
  EXPECT_LT((basis.evaluate(each) - mode_table(basis, false).transpose()).norm(), 1e-13);
  EXPECT_LT((basis.evaluate_conjugates(each) - mode_table(basis, true).transpose()).norm(), 1e-13);
}

TEST(FourierBasis, ProductsAreTheSumsOverTheLines)
{
  const FourierBasis basis(4, 16); // products reach beyond the highest harmonic that the lines tell apart
  const Eigen::MatrixXd samples = Eigen::MatrixXd::Random(2, 16);
  const FourierProducts products(basis, samples);
  const Eigen::MatrixXd modes = mode_table(basis, false), conjugates = mode_table(basis, true);
  for (unsigned int row = 0; row < basis.n_modes(); ++row)
    for (unsigned int column = 0; column < basis.n_modes(); ++column)
      for (Eigen::Index f = 0; f < 2; ++f)
      {
        double sum = 0;
        double partner_sum = 0;
        for (unsigned int j = 0; j < 16; ++j)
        {
          sum += samples(f, j) * modes(j, row) * modes(j, column);
          partner_sum += samples(f, j) * conjugates(j, row) * modes(j, column);
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
    EXPECT_LT((basis.project(samples) - samples * mode_table(basis, false)).norm(), 1e-13);
    EXPECT_LT((basis.project_on_conjugates(samples) - samples * mode_table(basis, true)).norm(), 1e-13);
    EXPECT_LT((basis.evaluate(amplitudes) - amplitudes * mode_table(basis, false).transpose()).norm(), 1e-13);
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
