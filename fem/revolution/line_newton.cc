#include "fem/revolution/line_newton.h"

#include "fem/contact/contact_solution.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// How far the step may miss that of Newton's method: share of the compliance that its functions leave out.
constexpr double step_accuracy = 1e-4;
constexpr Eigen::Index most_functions = 10;

/// Orthonormal polynomials of degree 0 ... @p n_functions - 1 at @p radii.
Eigen::MatrixXd polynomials(const Eigen::VectorXd &radii, Eigen::Index n_functions)
{
  const Eigen::Index n_radii = radii.size();
  const double middle = (radii(0) + radii(n_radii - 1)) / 2;
  const double half_width = std::max((radii(n_radii - 1) - radii(0)) / 2, 1e-3 * middle);
  Eigen::MatrixXd values(n_radii, n_functions);
  for (Eigen::Index i = 0; i < n_radii; ++i)
  {
    const double x = (radii(i) - middle) / half_width;
    for (Eigen::Index k = 0; k < n_functions; ++k) // Chebyshev's, which are far from dependent
      values(i, k) = k == 0 ? 1 : k == 1 ? x : 2 * x * values(i, k - 1) - values(i, k - 2);
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>(values).householderQ() *
         Eigen::MatrixXd::Identity(n_radii, n_functions);
}

HarmonicCompliance reduced_to(const Eigen::MatrixXd &functions, const HarmonicCompliance &whole)
{
  const auto reduce = [&](const Eigen::MatrixXd &matrix) -> Eigen::MatrixXd
  { return functions.transpose() * matrix * functions; };
  return { reduce(whole.normal), reduce(whole.radial), reduce(whole.azimuthal) };
}

} // namespace

LineNewton::LineNewton(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
                       const Eigen::MatrixXd &unbalanced, double negligible)
    : response(response)
{
  find_lines(tangent, unbalanced, negligible);
  choose_functions();
  eliminate_lines(tangent, unbalanced);
}

void LineNewton::find_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced,
                            double negligible)
{
  const Eigen::Index n_radii = response.n_radii();
  lines.resize(response.n_lines());
  Eigen::Index last_circle = -1;
  first_circle = n_radii;
  for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(lines.size()); ++j)
  {
    Line &line = lines[static_cast<std::size_t>(j)];
    const auto carries = [&](Eigen::Index i)
    {
      if (std::abs(unbalanced(i, j)) > negligible)
        return true;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, j * n_radii + i); entry; ++entry)
        if (entry.value() != 0)
          return true;
      return false;
    };
    Eigen::Index first = 0, end = n_radii;
    while (first < end && !carries(first))
      ++first;
    while (end > first && !carries(end - 1))
      --end;
    line.first = first;
    line.size = end - first;
    if (line.size == 0)
      continue;
    first_circle = std::min(first_circle, first);
    last_circle = std::max(last_circle, end - 1);
  }
  if (last_circle < 0)
    throw ContactFailure(ContactOutcome::linear_solver_failed, "No place of the contact zone carries load.");
  n_circles = last_circle - first_circle + 1;
}

void LineNewton::eliminate_lines(const Eigen::SparseMatrix<double> &tangent,
                                 const Eigen::MatrixXd &unbalanced)
{
  const Eigen::Index n_radii = response.n_radii();
  const Eigen::Index n_functions = functions.cols();
  const Eigen::VectorXd &radii = response.compliance().radii;
  Eigen::MatrixXd matrix, rhs;
  for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(lines.size()); ++j)
  {
    Line &line = lines[static_cast<std::size_t>(j)];
    if (line.size == 0)
      continue;
    // Both transposed, which makes the rows that T adds columns.
    const Eigen::MatrixXd local = response.local(j, line.first, line.size).transpose();
    // T is banded: its products are taken entry by entry. Right-hand sides T (functions, Q) and r.
    const double theta = response.basis().azimuth(static_cast<unsigned int>(j));
    Eigen::MatrixXd shape(line.size, n_functions + 3);
    shape.leftCols(n_functions) = functions_on(line);
    shape.col(n_functions).setOnes();
    shape.col(n_functions + 1) = radii.segment(line.first, line.size) * std::cos(theta);
    shape.col(n_functions + 2) = radii.segment(line.first, line.size) * std::sin(theta);
    matrix.setIdentity(line.size, line.size);
    rhs.setZero(line.size, n_functions + 4);
    for (Eigen::Index i = 0; i < line.size; ++i)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, j * n_radii + line.first + i); entry;
           ++entry)
        if (entry.value() != 0)
        {
          const Eigen::Index row = entry.row() - j * n_radii - line.first;
          matrix.col(row) += entry.value() * local.col(i);
          rhs.row(row).head(n_functions + 3) += entry.value() * shape.row(i);
        }
    rhs.col(n_functions + 3) = unbalanced.col(j).segment(line.first, line.size);
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factors(matrix);
    const Eigen::MatrixXd solution = factors.transpose().solve(rhs);
    line.answer = solution.leftCols(n_functions);
    line.moved = solution.middleCols(n_functions, 3);
    line.balanced = solution.col(n_functions + 3);
  }
}

void LineNewton::choose_functions()
{
  const unsigned int n_max = response.basis().n_harmonics();
  const Eigen::VectorXd radii = response.compliance().radii.segment(first_circle, n_circles);
  std::vector<HarmonicCompliance> whole;
  for (unsigned int n = 0; n <= n_max; ++n)
    whole.push_back(response.difference(n, first_circle, n_circles));
  const double allowed =
    step_accuracy *
    (response.compliance().beyond.normal.block(first_circle, first_circle, n_circles, n_circles).norm() +
     whole[0].normal.norm());
  for (Eigen::Index n_functions = std::min<Eigen::Index>(2, n_circles);; ++n_functions)
  {
    functions = polynomials(radii, n_functions);
    const auto left_out = [&](const Eigen::MatrixXd &matrix)
    {
      return (matrix - functions * (functions.transpose() * matrix * functions) * functions.transpose())
        .norm();
    };
    double worst = 0;
    for (const unsigned int n : { 0u, 1u, n_max / 2, n_max })
    {
      worst = std::max(worst, left_out(whole[n].normal));
      if (response.has_sliding())
        worst = std::max({ worst, left_out(whole[n].radial), left_out(whole[n].azimuthal) });
    }
    if (worst <= allowed || n_functions >= std::min(n_circles, most_functions))
      break;
  }
  for (const HarmonicCompliance &harmonic : whole)
    reduced.push_back(reduced_to(functions, harmonic));
}

LineNewton::Increment LineNewton::solve(const LinearConditions &conditions,
                                        const Eigen::Vector3d &residual) const
{
  const FourierBasis &basis = response.basis();
  const Eigen::Index p = functions.cols();
  const Eigen::Index n_modes = basis.n_modes();
  const Eigen::Index n_lines = response.n_lines();
  const Eigen::Index n_radii = response.n_radii();
  const bool slides = response.has_sliding();
  const Eigen::Index n_kinds = slides ? 3 : 1; // normal, radial and azimuthal forces

  // What each line contributes, by kind: its answer to the functions, to the table motions and to what is
  // unbalanced, tested with the functions; and the same tested with the conditions.
  std::vector<Eigen::MatrixXd> to_functions(n_kinds, Eigen::MatrixXd::Zero(p * p, n_lines));
  std::vector<Eigen::MatrixXd> to_motions(n_kinds, Eigen::MatrixXd::Zero(p * 3, n_lines));
  std::vector<Eigen::MatrixXd> to_unbalanced(n_kinds, Eigen::MatrixXd::Zero(p, n_lines));
  Eigen::MatrixXd conditions_on_functions = Eigen::MatrixXd::Zero(3 * p, n_lines);
  Eigen::Matrix3d corner = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = residual;
  for (Eigen::Index j = 0; j < n_lines; ++j)
  {
    const Line &line = lines[static_cast<std::size_t>(j)];
    if (line.size == 0)
      continue;
    const Eigen::MatrixXd shape = functions_on(line);
    for (Eigen::Index kind = 0; kind < n_kinds; ++kind)
    {
      Eigen::MatrixXd test = shape;
      if (kind > 0)
        test = (kind == 1 ? response.radial_traction() : response.azimuthal_traction())
                 .col(j)
                 .segment(line.first, line.size)
                 .asDiagonal() *
               shape;
      to_functions[kind].col(j) = (test.transpose() * line.answer).reshaped();
      to_motions[kind].col(j) = (test.transpose() * line.moved).reshaped();
      to_unbalanced[kind].col(j) = test.transpose() * line.balanced;
    }
    const auto weights = conditions.weights().middleRows(j * n_radii + line.first, line.size);
    conditions_on_functions.col(j) = (weights.transpose() * line.answer).reshaped();
    corner += weights.transpose() * line.moved;
    rhs += weights.transpose() * line.balanced;
  }

  // Unknowns: amplitudes y, function running fastest within a mode, and the table motions: A y + B dq = a,
  // C y + (corner - weight) dq = rhs. Columns beside A: B and a.
  const Eigen::Index n = n_modes * p;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd beside = Eigen::MatrixXd::Zero(n, 4);
  for (Eigen::Index kind = 0; kind < n_kinds; ++kind)
  {
    const bool conjugate = kind == 2;
    const FourierProducts products(basis, to_functions[kind], true);
    const auto project = [&](const Eigen::MatrixXd &samples)
    { return conjugate ? basis.project_on_conjugates(samples) : basis.project(samples); };
    const Eigen::MatrixXd motions = project(to_motions[kind]);       // [p * 3, n_modes]
    const Eigen::MatrixXd unbalanced = project(to_unbalanced[kind]); // [p, n_modes]
    Eigen::MatrixXd sums(p, n);
    for (Eigen::Index row = 0; row < n_modes; ++row)
    {
      const auto row_mode = static_cast<unsigned int>(row);
      for (Eigen::Index column = 0; column < n_modes; ++column)
      {
        const FourierProducts::OfPair pair =
          conjugate ? products.with_conjugate(row_mode, static_cast<unsigned int>(column))
                    : products(row_mode, static_cast<unsigned int>(column));
        double *block = sums.data() + column * p * p;
        for (Eigen::Index k = 0; k < p * p; ++k)
          block[k] = pair(k);
      }
      const HarmonicCompliance &harmonic = reduced[FourierBasis::harmonic(row_mode)];
      const Eigen::MatrixXd weight = (kind == 0   ? harmonic.normal
                                      : kind == 1 ? harmonic.radial
                                                  : harmonic.azimuthal) /
                                     FourierBasis::norm(row_mode);
      matrix.block(row * p, 0, p, n).noalias() += weight * sums;
      beside.block(row * p, 0, p, 3).noalias() += weight * motions.col(row).reshaped(p, 3);
      beside.block(row * p, 3, p, 1).noalias() += weight * unbalanced.col(row);
    }
  }
  matrix.diagonal().array() += 1;
  Eigen::MatrixXd tested(3, n);                                            // C
  const Eigen::MatrixXd on_modes = basis.project(conditions_on_functions); // [3 * p, n_modes]
  for (Eigen::Index mode = 0; mode < n_modes; ++mode)
    tested.middleCols(mode * p, p) = on_modes.col(mode).reshaped(3, p);

  // With the table held the system is that of an elastic foot on springs; the motions follow by themselves.
  const Eigen::MatrixXd held = matrix.partialPivLu().solve(beside);
  Increment increment;
  increment.resistance = corner - tested * held.leftCols<3>();
  // Forces count per N and lengths per the depth that N makes, tilts as heights at the rim: rows and columns
  // of like size.
  const double length = response.compliance().radii(n_radii - 1);
  const Eigen::Vector3d row_scale = Eigen::Vector3d(1, 1 / length, 1 / length) / corner(0, 0);
  const Eigen::Vector3d column_scale(1, 1 / length, 1 / length);
  const Eigen::Matrix3d against =
    row_scale.asDiagonal() * (increment.resistance - conditions.motion_weights()) * column_scale.asDiagonal();
  increment.motion =
    column_scale.asDiagonal() *
    against.partialPivLu().solve(row_scale.asDiagonal() * (rhs - tested * held.col(3))).eval();
  const Eigen::VectorXd solution = held.col(3) - held.leftCols<3>() * increment.motion;
  if (!solution.allFinite() || !increment.motion.allFinite())
    throw ContactFailure(
      ContactOutcome::linear_solver_failed,
      "The contact system of the body of revolution is singular: the loaded places do not support the foot.");

  increment.forces = Eigen::MatrixXd::Zero(n_radii, n_lines);
  const Eigen::MatrixXd amplitudes = basis.evaluate(solution.reshaped(p, n_modes)); // [p, n_lines]
  for (Eigen::Index j = 0; j < n_lines; ++j)
  {
    const Line &line = lines[static_cast<std::size_t>(j)];
    if (line.size > 0)
      increment.forces.col(j).segment(line.first, line.size) =
        line.balanced - line.answer * amplitudes.col(j) - line.moved * increment.motion;
  }
  return increment;
}

} // namespace stemware::fem
