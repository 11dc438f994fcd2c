#include "fem/fourier_basis.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

using boost::math::double_constants::pi;

namespace
{
void require_resolved(unsigned int n_harmonics, unsigned int n_lines)
{
  if (n_harmonics < 1)
    throw std::invalid_argument(
      "Harmonics = 0 is not allowed: a moment on the foot needs at least the first one.");
  if (n_lines < 2 * n_harmonics + 1)
    throw std::invalid_argument(std::to_string(n_lines) + " azimuth lines cannot resolve " +
                                std::to_string(n_harmonics) + " harmonics; give at least " +
                                std::to_string(2 * n_harmonics + 1) + " lines.");
}
} // namespace

FourierBasis::FourierBasis(unsigned int n_harmonics, unsigned int n_lines)
    : n(n_harmonics)
{
  require_resolved(n_harmonics, n_lines);
  cosines.resize(n_lines);
  sines.resize(n_lines);
  for (unsigned int k = 0; 2 * k <= n_lines; ++k)
  {
    const double angle = 2 * pi * k / n_lines;
    const unsigned int mirror = (n_lines - k) % n_lines;
    cosines[mirror] = cosines[k] = std::cos(angle);
    sines[mirror] = -std::sin(angle);
    sines[k] = k == mirror ? 0 : std::sin(angle);
  }
  mode_values.resize(n_lines, n_modes());
  partner_values.resize(n_lines, n_modes());
  cosine_values.resize(n_lines, 2 * n + 1);
  sine_values.resize(n_lines, 2 * n + 1);
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    for (unsigned int mode = 0; mode < n_modes(); ++mode)
    {
      const double even = cosine(harmonic(mode), j);
      const double odd = sine(harmonic(mode), j);
      mode_values(j, mode) = is_sine(mode) ? odd : even;
      partner_values(j, mode) = is_sine(mode) ? -even : odd;
    }
    for (unsigned int p = 0; p <= 2 * n; ++p)
    {
      cosine_values(j, p) = cosine(p, j);
      sine_values(j, p) = sine(p, j);
    }
  }
}

double FourierBasis::azimuth(unsigned int line) const
{
  return 2 * pi * line / n_lines();
}

double FourierBasis::norm(unsigned int mode)
{
  return mode == 0 ? 2 * pi : pi;
}

FourierProducts::FourierProducts(const FourierBasis &basis, const Eigen::MatrixXd &samples, bool with_sines)
    : even(basis.cosine_table().transpose() * samples.transpose())
{
  if (with_sines)
    odd = basis.sine_table().transpose() * samples.transpose();
}

double FourierProducts::product(Eigen::Index f, unsigned int row, bool row_is_sine, unsigned int column,
                                bool column_is_sine) const
{
  const unsigned int sum = row + column;
  const unsigned int difference = row > column ? row - column : column - row;
  if (row_is_sine == column_is_sine)
    return (even(difference, f) + (row_is_sine ? -even(sum, f) : even(sum, f))) / 2;
  if (odd.size() == 0)
    return 0;
  // sin a cos b = (sin(a + b) + sin(a - b)) / 2, a being the harmonic of the sine.
  const bool sine_is_larger = row_is_sine ? row > column : column > row;
  return (odd(sum, f) + (sine_is_larger ? odd(difference, f) : -odd(difference, f))) / 2;
}

} // namespace stemware::fem
