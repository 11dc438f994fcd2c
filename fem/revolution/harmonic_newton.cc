#include "fem/revolution/harmonic_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <limits>
#include <stdexcept>

namespace stemware::fem
{

namespace
{
/// Modes stacked: circle index running fastest.
Eigen::VectorXd stacked(const ModeMatrix &modes)
{
  return Eigen::Map<const Eigen::VectorXd>(modes.data(), modes.size());
}

ModeMatrix unstacked(const Eigen::VectorXd &values, Eigen::Index n_circles)
{
  return Eigen::Map<const ModeMatrix>(values.data(), n_circles, values.size() / n_circles);
}
} // namespace

HarmonicNewton::HarmonicNewton(const FourierBasis &basis, const ContactCompliance &compliance,
                               const LineTangents &tangents, bool even)
    : basis(basis)
    , compliance(compliance)
    , tangents(tangents)
    , even(even)
    , n_circles(static_cast<unsigned int>(tangents.circles.size()))
{
  for (unsigned int mode = 0; mode < basis.n_modes(); ++mode)
    if (!even || !FourierBasis::is_sine(mode))
      used_modes.push_back(mode);
  for (const unsigned int mode : used_modes)
  {
    if (FourierBasis::is_sine(mode))
    {
      stiffness.push_back(stiffness.back());
      continue;
    }
    const Eigen::MatrixXd part = on_circles(compliance.harmonics[FourierBasis::harmonic(mode)].normal);
    const Eigen::LLT<Eigen::MatrixXd> factors(part / FourierBasis::norm(mode));
    if (factors.info() != Eigen::Success)
      throw std::runtime_error(
        "The compliance of the loaded circles is singular: the meridional mesh is distorted.");
    stiffness.push_back(factors.solve(Eigen::MatrixXd::Identity(n_circles, n_circles)));
  }
  normal_tangent = assemble(FourierProducts(basis, tangents.values, !even), false);
}

Eigen::MatrixXd HarmonicNewton::assemble(const FourierProducts &products, bool with_conjugate) const
{
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size(), size());
  for (std::size_t column = 0; column < used_modes.size(); ++column)
    for (std::size_t row = 0; row < used_modes.size(); ++row)
    {
      const FourierProducts::OfPair sums = with_conjugate
                                             ? products.with_conjugate(used_modes[row], used_modes[column])
                                             : products(used_modes[row], used_modes[column]);
      for (std::size_t c = 0; c < tangents.coupled_pairs.size(); ++c)
      {
        const auto [p, q] = tangents.coupled_pairs[c];
        const double value = sums(static_cast<Eigen::Index>(c));
        matrix(row * n_circles + p, column * n_circles + q) = value;
        matrix(row * n_circles + q, column * n_circles + p) = value;
      }
    }
  return matrix;
}

void HarmonicNewton::add_sliding(const Eigen::MatrixXd &radial, const Eigen::MatrixXd &azimuthal)
{
  // The force of circle p takes the direction of friction there, so that a coupled pair p, q is no longer
  // symmetric.
  const auto tangent_of = [&](const Eigen::MatrixXd &traction, bool with_conjugate)
  {
    Eigen::MatrixXd upper = tangents.values;
    Eigen::MatrixXd lower = tangents.values;
    for (std::size_t c = 0; c < tangents.coupled_pairs.size(); ++c)
    {
      const auto row = static_cast<Eigen::Index>(c);
      const auto [p, q] = tangents.coupled_pairs[c];
      upper.row(row).array() *= traction.row(tangents.circles[p]).array();
      lower.row(row).array() *= traction.row(tangents.circles[q]).array();
    }
    // A component even in theta meets the modes themselves, an odd one their conjugates: products with sines
    // either way.
    const Eigen::MatrixXd above = assemble(FourierProducts(basis, upper, true), with_conjugate);
    const Eigen::MatrixXd below = assemble(FourierProducts(basis, lower, true), with_conjugate);
    Eigen::MatrixXd matrix = above;
    for (Eigen::Index column = 0; column < size(); ++column)
      for (Eigen::Index row = 0; row < size(); ++row)
        if (row % n_circles > column % n_circles)
          matrix(row, column) = below(row, column);
    return matrix;
  };
  radial_tangent = tangent_of(radial, false);
  azimuthal_tangent = tangent_of(azimuthal, true);
}

Eigen::MatrixXd HarmonicNewton::motion_modes() const
{
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(size(), even ? 2 : 3);
  for (unsigned int p = 0; p < n_circles; ++p)
  {
    const double radius = compliance.radii(tangents.circles[p]);
    motions(p, 0) = 1;
    motions(n_circles + p, 1) = radius;
    if (!even)
      motions(2 * n_circles + p, 2) = radius;
  }
  return motions;
}

ModeMatrix HarmonicNewton::stiffness_times(const ModeMatrix &displacement) const
{
  ModeMatrix forces(displacement.rows(), displacement.cols());
  for (std::size_t k = 0; k < used_modes.size(); ++k)
    forces.col(static_cast<Eigen::Index>(k)) = stiffness[k] * displacement.col(static_cast<Eigen::Index>(k));
  return forces;
}

Eigen::MatrixXd HarmonicNewton::on_circles(const Eigen::MatrixXd &whole) const
{
  Eigen::MatrixXd part(n_circles, n_circles);
  for (unsigned int p = 0; p < n_circles; ++p)
    for (unsigned int q = 0; q < n_circles; ++q)
      part(p, q) = whole(tangents.circles[p], tangents.circles[q]);
  return part;
}

Eigen::MatrixXd HarmonicNewton::sliding_response(unsigned int k) const
{
  const HarmonicCompliance &harmonic = compliance.harmonics[FourierBasis::harmonic(used_modes[k])];
  const Eigen::MatrixXd radial = on_circles(harmonic.radial);
  const Eigen::MatrixXd azimuthal = on_circles(harmonic.azimuthal);
  const Eigen::Index row = k * n_circles;
  return stiffness[k] *
         (radial * radial_tangent.middleRows(row, n_circles) +
          azimuthal * azimuthal_tangent.middleRows(row, n_circles)) /
         FourierBasis::norm(used_modes[k]);
}

Eigen::MatrixXd HarmonicNewton::bordered_matrix(const Eigen::MatrixXd &motions) const
{
  const Eigen::MatrixXd resisted = normal_tangent * motions;
  const Eigen::Index n = size();
  const Eigen::Index n_motions = motions.cols();
  Eigen::MatrixXd matrix(n + n_motions, n + n_motions);
  matrix.topLeftCorner(n, n) = normal_tangent;
  matrix.topRightCorner(n, n_motions) = resisted;
  matrix.bottomLeftCorner(n_motions, n) = resisted.transpose();
  matrix.bottomRightCorner(n_motions, n_motions) = motions.transpose() * resisted;
  for (unsigned int k = 0; k < used_modes.size(); ++k)
  {
    const Eigen::Index row = k * n_circles;
    if (has_sliding())
    {
      const Eigen::MatrixXd moved = sliding_response(k);
      matrix.block(row, 0, n_circles, n) += moved;
      matrix.block(row, n, n_circles, n_motions) += moved * motions;
    }
    matrix.block(row, row, n_circles, n_circles) += stiffness[k];
  }
  return matrix;
}

void HarmonicNewton::set_conditions(const NewtonConditions &conditions, double length,
                                    Eigen::MatrixXd &matrix)
{
  const Eigen::DiagonalMatrix<double, 3> scale(1, 1 / length, 1 / length);
  matrix.bottomLeftCorner(3, matrix.cols() - 3) = scale * *conditions.rows;
  matrix.bottomRightCorner(3, 3) = scale * conditions.corner * scale;
}

HarmonicNewton::Result HarmonicNewton::solve(const ModeMatrix &residual,
                                             const NewtonConditions &conditions) const
{
  // Tilts count as heights at the rim, so that all unknowns are lengths.
  Eigen::MatrixXd motions = motion_modes();
  const double length = compliance.radii(compliance.radii.size() - 1);
  const Eigen::Index n = size();
  const Eigen::Index n_motions = motions.cols();
  motions.rightCols(n_motions - 1) /= length;

  Eigen::MatrixXd matrix = bordered_matrix(motions);
  if (conditions.rows)
    set_conditions(conditions, length, matrix);
  Eigen::VectorXd solution(n + n_motions);
  solution << stacked(residual), conditions.residual.head(n_motions);
  solution.tail(n_motions - 1) /= length;
  if (has_sliding() || conditions.rows)
    solution = matrix.partialPivLu().solve(solution).eval();
  else
  {
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(matrix);
    if (factors.info() == Eigen::Success)
      factors.solveInPlace(solution);
    else
      solution.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  if (!solution.allFinite())
    throw std::runtime_error(
      "The contact system of the body of revolution is singular: the loaded places do not support the foot.");

  Result result;
  const Eigen::VectorXd normal_displacement = solution.head(n) + motions * solution.tail(n_motions);
  result.motion.setZero();
  result.motion.head(n_motions) = solution.tail(n_motions);
  result.motion.tail<2>() /= length;
  result.normal_decrement = unstacked(normal_tangent * normal_displacement, n_circles);
  if (has_sliding())
  {
    result.radial_decrement = unstacked(radial_tangent * normal_displacement, n_circles);
    result.azimuthal_decrement = unstacked(azimuthal_tangent * normal_displacement, n_circles);
  }
  return result;
}

} // namespace stemware::fem
