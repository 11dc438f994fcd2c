#pragma once

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Trigonometric functions of theta on equidistant azimuth lines theta_j = 2 pi j / n_lines.
///
/// Mode 0 is 1, mode 2n - 1 is cos(n theta), mode 2n is sin(n theta), n = 1 ... n_harmonics. Values are
/// exactly even and odd in theta, so that what is mirror-symmetric stays so to the last bit.
class FourierBasis
{
public:
  /// Throws std::invalid_argument unless n_lines >= 2 n_harmonics + 1 (fewer lines cannot tell the modes
  /// apart) and n_harmonics >= 1.
  FourierBasis(unsigned int n_harmonics, unsigned int n_lines);

  unsigned int n_harmonics() const { return n; }
  unsigned int n_lines() const { return static_cast<unsigned int>(cosines.size()); }
  unsigned int n_modes() const { return 2 * n + 1; }
  double azimuth(unsigned int line) const;

  static unsigned int harmonic(unsigned int mode) { return (mode + 1) / 2; }
  static bool is_sine(unsigned int mode) { return mode > 0 && mode % 2 == 0; }
  /// int_0^{2 pi} (mode)^2 dtheta: 2 pi or pi.
  static double norm(unsigned int mode);

  double cosine(unsigned int harmonic, unsigned int line) const
  {
    return cosines[harmonic * line % n_lines()];
  }
  double sine(unsigned int harmonic, unsigned int line) const { return sines[harmonic * line % n_lines()]; }

  /// Values of the modes on the lines, shape [n_lines, n_modes].
  const Eigen::MatrixXd &values() const { return mode_values; }
  /// The partner -(1/n) d/dtheta of every mode, sin for cos and -cos for sin (0 for mode 0): the azimuthal
  /// component that goes with it.
  const Eigen::MatrixXd &partners() const { return partner_values; }
  /// cos(p theta_j), p = 0 ... 2 n_harmonics, shape [n_lines, 2 n_harmonics + 1]; `sine_table` likewise.
  const Eigen::MatrixXd &cosine_table() const { return cosine_values; }
  const Eigen::MatrixXd &sine_table() const { return sine_values; }

private:
  unsigned int n;
  std::vector<double> cosines; ///< cos(2 pi k / n_lines)
  std::vector<double> sines;
  Eigen::MatrixXd mode_values;
  Eigen::MatrixXd partner_values;
  Eigen::MatrixXd cosine_values;
  Eigen::MatrixXd sine_values;
};

/// Sums over the lines of a product of two modes with given functions: sum_j row(theta_j) column(theta_j)
/// f(theta_j).
///
/// cos cos, sin cos and sin sin are half the sums of harmonics n -/+ m of f, so these are all that is
/// computed.
class FourierProducts
{
public:
  /// @p samples: one function a row, shape [n_functions, n_lines]. Without @p with_sines the functions are
  /// taken as even in theta.
  FourierProducts(const FourierBasis &basis, const Eigen::MatrixXd &samples, bool with_sines);

  /// For function @p f and two modes.
  double operator()(Eigen::Index f, unsigned int row_mode, unsigned int column_mode) const
  {
    return product(f, FourierBasis::harmonic(row_mode), FourierBasis::is_sine(row_mode),
                   FourierBasis::harmonic(column_mode), FourierBasis::is_sine(column_mode));
  }
  /// The same with the partner of the row's mode.
  double with_partner(Eigen::Index f, unsigned int row_mode, unsigned int column_mode) const
  {
    const bool row_is_sine = FourierBasis::is_sine(row_mode);
    const double value = product(f, FourierBasis::harmonic(row_mode), !row_is_sine,
                                 FourierBasis::harmonic(column_mode), FourierBasis::is_sine(column_mode));
    return row_is_sine ? -value : value;
  }

private:
  double product(Eigen::Index f, unsigned int row, bool row_is_sine, unsigned int column,
                 bool column_is_sine) const;

  Eigen::MatrixXd even; ///< sums with cos(p theta), shape [2 n_harmonics + 1, n_functions]
  Eigen::MatrixXd odd;  ///< sums with sin(p theta)
};

} // namespace stemware::fem
