#pragma once

#include <Eigen/Core>

namespace stemware::fem
{

/// Trigonometric functions of theta on equidistant azimuth lines theta_j = 2 pi j / n_lines. Mode 0 is 1,
/// mode 2n - 1 is cos(n theta), mode 2n is sin(n theta), n = 1 ... n_harmonics. Values are exactly even or
/// odd, which preserves mirror symmetry to the last bit.
class FourierBasis
{
public:
  /// Throws std::invalid_argument unless n_harmonics >= 1 and n_lines >= 2 n_harmonics + 1 (no aliasing).
  FourierBasis(unsigned int n_harmonics, unsigned int n_lines);

  unsigned int n_harmonics() const { return n; }
  unsigned int n_lines() const { return static_cast<unsigned int>(cosine_values.rows()); }
  unsigned int n_modes() const { return 2 * n + 1; }
  double azimuth(unsigned int line) const;

  static unsigned int harmonic(unsigned int mode) { return (mode + 1) / 2; }
  static bool is_sine(unsigned int mode) { return mode > 0 && mode % 2 == 0; }
  /// Returns int_0^{2 pi} (mode)^2 dtheta: 2 pi for the mean, pi for all other modes.
  static double norm(unsigned int mode);

  /// Returns sum_j samples(i, j) mode(theta_j): shape [n_rows, n_lines] to [n_rows, n_modes]. Exactly even
  /// samples give exactly zero sine modes.
  Eigen::MatrixXd project(const Eigen::Ref<const Eigen::MatrixXd> &samples) const;
  /// Returns the projections onto the conjugate of each mode; shapes as project().
  Eigen::MatrixXd project_on_conjugates(const Eigen::Ref<const Eigen::MatrixXd> &samples) const;
  /// Returns sum_mode amplitudes(i, mode) mode(theta_j): shape [n_rows, n_modes] to [n_rows, n_lines].
  /// Without sine modes the values are exactly even.
  Eigen::MatrixXd evaluate(const Eigen::MatrixXd &amplitudes) const;
  /// Evaluates conjugates -(1/n) d/dtheta (azimuthal components): sin for cos, -cos for sin, 0 for mode 0.
  Eigen::MatrixXd evaluate_conjugates(const Eigen::MatrixXd &amplitudes) const;

  /// Returns cos(p theta_j) (sine_table(): sin), p = 0 ... 2 n_harmonics; shape [n_lines, 2 n_harmonics + 1].
  const Eigen::MatrixXd &cosine_table() const { return cosine_values; }
  const Eigen::MatrixXd &sine_table() const { return sine_values; }

private:
  /// Returns the indices of the modes cos(theta), cos(2 theta) ...
  auto cosine_modes() const { return Eigen::seqN(1, static_cast<Eigen::Index>(n), Eigen::fix<2>); }
  auto sine_modes() const { return Eigen::seqN(2, static_cast<Eigen::Index>(n), Eigen::fix<2>); }

  unsigned int n;
  Eigen::MatrixXd cosine_values;
  Eigen::MatrixXd sine_values;
};

/// Sums over the lines of two modes and given functions, sum_j row(theta_j) column(theta_j) f(theta_j), from
/// the sums of f with cos(p theta) and sin(p theta), p the sum or difference of both harmonics.
class FourierProducts
{
public:
  /// @p samples: one function a row, shape [n_functions, n_lines].
  FourierProducts(const FourierBasis &basis, const Eigen::Ref<const Eigen::MatrixXd> &samples);

  /// Returns the sums for a pair of modes, by function, as an expression that is valid as long as the
  /// FourierProducts. @p conjugate: the row's mode is replaced by its conjugate.
  auto operator()(unsigned int row_mode, unsigned int column_mode, bool conjugate) const
  {
    const unsigned int row = FourierBasis::harmonic(row_mode), column = FourierBasis::harmonic(column_mode);
    const bool row_is_sine = FourierBasis::is_sine(row_mode) != conjugate;
    const bool is_even = row_is_sine == FourierBasis::is_sine(column_mode);
    const bool sine_is_larger = row_is_sine ? row > column : column > row;
    // cos a cos b = (cos(a - b) + cos(a + b)) / 2, sin a sin b = (cos(a - b) - cos(a + b)) / 2,
    // sin a cos b = (sin(a - b) + sin(a + b)) / 2; the conjugate of a sine is minus the cosine.
    const double half = conjugate && !row_is_sine ? -0.5 : 0.5;
    const Eigen::MatrixXd &table = is_even ? even : odd;
    return (is_even || sine_is_larger ? half : -half) *
             table.col(row > column ? row - column : column - row) +
           (is_even && row_is_sine ? -half : half) * table.col(row + column);
  }

private:
  Eigen::MatrixXd even; ///< sums with cos(p theta), shape [n_functions, 2 n_harmonics + 1]
  Eigen::MatrixXd odd;  ///< sums with sin(p theta)
};

} // namespace stemware::fem
