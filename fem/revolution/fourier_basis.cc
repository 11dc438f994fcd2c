#include "fem/revolution/fourier_basis.h"

#include "ring_model/load/constants.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace stemware::fem
{

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

/// Sums (even) and differences (odd) of the values of functions on the lines j and -j, j = 0 ... n_lines / 2.
/// On a line in the plane of symmetry, `even` is the value and `odd` is 0.
struct MirrorSums
{
  explicit MirrorSums(const Eigen::Ref<const Eigen::MatrixXd> &samples)
  {
    const Eigen::Index n_lines = samples.cols();
    const Eigen::Index n_pairs = (n_lines - 1) / 2;
    const auto mirrored = samples.rightCols(n_pairs).rowwise().reverse();
    even = samples.leftCols(n_lines / 2 + 1);
    odd = Eigen::MatrixXd::Zero(even.rows(), even.cols());
    odd.middleCols(1, n_pairs) = even.middleCols(1, n_pairs) - mirrored;
    even.middleCols(1, n_pairs) += mirrored;
    has_odd = (odd.array() != 0).any();
  }

  Eigen::MatrixXd even; ///< shape [n_functions, n_lines / 2 + 1]
  Eigen::MatrixXd odd;
  bool has_odd;
};
} // namespace

FourierBasis::FourierBasis(unsigned int n_harmonics, unsigned int n_lines)
    : n(n_harmonics)
{
  require_resolved(n_harmonics, n_lines);
  std::vector<double> cosines(n_lines), sines(n_lines); // of 2 pi k / n_lines
  for (unsigned int k = 0; 2 * k <= n_lines; ++k)
  {
    const double angle = 2 * ring::pi * k / n_lines;
    const unsigned int mirror = (n_lines - k) % n_lines;
    cosines[mirror] = cosines[k] = std::cos(angle);
    sines[mirror] = -std::sin(angle);
    sines[k] = k == mirror ? 0 : std::sin(angle);
  }
  cosine_values.resize(n_lines, 2 * n + 1);
  sine_values.resize(n_lines, 2 * n + 1);
  for (unsigned int j = 0; j < n_lines; ++j)
    for (unsigned int p = 0; p <= 2 * n; ++p)
    {
      cosine_values(j, p) = cosines[p * j % n_lines];
      sine_values(j, p) = sines[p * j % n_lines];
    }
}

double FourierBasis::azimuth(unsigned int line) const
{
  return 2 * ring::pi * line / n_lines();
}

double FourierBasis::norm(unsigned int mode)
{
  return mode == 0 ? 2 * ring::pi : ring::pi;
}

Eigen::MatrixXd FourierBasis::project(const Eigen::Ref<const Eigen::MatrixXd> &samples) const
{
  const MirrorSums mirrored(samples);
  const Eigen::Index n_half = mirrored.even.cols();
  const Eigen::MatrixXd even = mirrored.even * cosine_values.topLeftCorner(n_half, n + 1);
  Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Zero(samples.rows(), n_modes());
  amplitudes.col(0) = even.col(0);
  amplitudes(Eigen::all, cosine_modes()) = even.rightCols(n);
  if (mirrored.has_odd)
    amplitudes(Eigen::all, sine_modes()) = mirrored.odd * sine_values.block(0, 1, n_half, n);
  return amplitudes;
}

Eigen::MatrixXd FourierBasis::project_on_conjugates(const Eigen::Ref<const Eigen::MatrixXd> &samples) const
{
  const Eigen::MatrixXd on_modes = project(samples);
  Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Zero(samples.rows(), n_modes());
  amplitudes(Eigen::all, cosine_modes()) = on_modes(Eigen::all, sine_modes());
  amplitudes(Eigen::all, sine_modes()) = -on_modes(Eigen::all, cosine_modes());
  return amplitudes;
}

Eigen::MatrixXd FourierBasis::evaluate(const Eigen::MatrixXd &amplitudes) const
{
  const Eigen::Index n_half = n_lines() / 2 + 1;
  Eigen::MatrixXd even_modes(amplitudes.rows(), n + 1);
  even_modes << amplitudes.col(0), amplitudes(Eigen::all, cosine_modes());
  const Eigen::MatrixXd odd_modes = amplitudes(Eigen::all, sine_modes());
  Eigen::MatrixXd samples(amplitudes.rows(), n_lines());
  samples.leftCols(n_half).noalias() = even_modes * cosine_values.topLeftCorner(n_half, n + 1).transpose();
  const bool has_odd = (odd_modes.array() != 0).any();
  Eigen::MatrixXd odd;
  if (has_odd)
    odd = odd_modes * sine_values.block(0, 1, n_half, n).transpose();
  for (Eigen::Index line = 0; line < n_half; ++line)
  {
    const Eigen::Index mirror = (n_lines() - line) % n_lines();
    if (mirror != line)
      samples.col(mirror) = samples.col(line);
    if (!has_odd)
      continue;
    samples.col(line) += odd.col(line);
    if (mirror != line)
      samples.col(mirror) -= odd.col(line);
  }
  return samples;
}

Eigen::MatrixXd FourierBasis::evaluate_conjugates(const Eigen::MatrixXd &amplitudes) const
{
  Eigen::MatrixXd of_modes = Eigen::MatrixXd::Zero(amplitudes.rows(), n_modes());
  of_modes(Eigen::all, sine_modes()) = amplitudes(Eigen::all, cosine_modes());
  of_modes(Eigen::all, cosine_modes()) = -amplitudes(Eigen::all, sine_modes());
  return evaluate(of_modes);
}

FourierProducts::FourierProducts(const FourierBasis &basis, const Eigen::Ref<const Eigen::MatrixXd> &samples)
{
  const MirrorSums mirrored(samples);
  const Eigen::Index n_half = mirrored.even.cols();
  even = mirrored.even * basis.cosine_table().topRows(n_half);
  odd = mirrored.odd * basis.sine_table().topRows(n_half);
}

} // namespace stemware::fem
