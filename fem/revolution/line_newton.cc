#include "fem/revolution/line_newton.h"

#include "fem/contact/contact_solution.h"
#include "fem/revolution/dense_algebra.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

/// Largest accepted norm of the part of the compliance that the polynomials in r do not represent, relative
/// to the norm of the compliance.
constexpr double step_accuracy = 1e-4;
/// From this number of polynomials on (land wide compared with the shortest wavelength), a step less accurate
/// than step_accuracy is accepted if its contraction factor is at most slowest_contraction.
constexpr Eigen::Index many_functions = 10;
constexpr double slowest_contraction = 0.2;

/// Returns the orthonormal polynomials of degree 0 ... @p n_functions - 1 at @p radii.
Eigen::MatrixXd polynomials(const Eigen::VectorXd &radii, Eigen::Index n_functions)
{
  const Eigen::Index n_radii = radii.size();
  const double middle = (radii(0) + radii(n_radii - 1)) / 2;
  const double half_width = std::max((radii(n_radii - 1) - radii(0)) / 2, 1e-3 * middle);
  Eigen::MatrixXd values(n_radii, n_functions);
  for (Eigen::Index i = 0; i < n_radii; ++i)
  {
    const double x = (radii(i) - middle) / half_width;
    for (Eigen::Index k = 0; k < n_functions; ++k) // Chebyshev polynomials are well conditioned
      values(i, k) = k == 0 ? 1 : k == 1 ? x : 2 * x * values(i, k - 1) - values(i, k - 2);
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>(values).householderQ() *
         Eigen::MatrixXd::Identity(n_radii, n_functions);
}

class LineNewton
{
public:
  LineNewton(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
             const Eigen::MatrixXd &unbalanced, SmoothFunctions &cached, double negligible)
      : response(response)
      , smooth(cached)
  {
    find_lines(tangent, unbalanced, negligible);
    if (cached.first != circles.first || cached.size != circles.size ||
        cached.has_sliding != response.has_sliding())
      cached = chosen_functions();
    eliminate_lines(tangent, unbalanced);
  }

  LineIncrement solve(const LinearConditions &conditions, const Eigen::Vector3d &residual) const
  {
    const Eigen::Index p = smooth.values.cols(), n_modes = response.basis().n_modes(), n = n_modes * p;
    const std::vector<Eigen::MatrixXd> on_lines = sums_on_lines(conditions);
    const Eigen::MatrixXd &of_conditions = on_lines.back();
    const Eigen::Matrix<double, 3, 4> beside = of_conditions.bottomRows(12).rowwise().sum().reshaped(3, 4);

    // Unknowns: amplitudes y (function index fastest within a mode) and table motions dq.
    // A y + B dq = a, C y + (D - H) dq = rhs, with D in the first columns of `beside` and the motion weights
    // H. Eliminating y leaves a 3 x 3 system for dq.
    RowMatrix system = system_of_amplitudes(on_lines); // [A, B, a]
    solve_dense(system, 4);                            // overwrites B and a with A^-1 B and A^-1 a
    const Eigen::MatrixXd held = system.rightCols<4>();
    const Eigen::MatrixXd tested = // C: one row per condition, one column per amplitude
      response.basis().project(of_conditions.topRows(3 * p)).reshaped(3, n);
    LineIncrement increment;
    increment.resistance = beside.leftCols<3>() - tested * held.leftCols<3>();

    // Scaling: forces are divided by the stiffness beside(0, 0), moments also by the radius of the rim, and
    // tilts become heights at the rim.
    const double length = response.compliance().radii(response.n_radii() - 1);
    const Eigen::Vector3d row_scale = Eigen::Vector3d(1, 1 / length, 1 / length) / beside(0, 0);
    const Eigen::Vector3d column_scale(1, 1 / length, 1 / length);
    const Eigen::Matrix3d scaled_resistance = row_scale.asDiagonal() *
                                              (increment.resistance - conditions.motion_weights()) *
                                              column_scale.asDiagonal();
    const Eigen::Vector3d rhs = residual + beside.col(3) - tested * held.col(3);
    increment.motion =
      column_scale.asDiagonal() * scaled_resistance.partialPivLu().solve(row_scale.asDiagonal() * rhs).eval();
    const Eigen::VectorXd amplitudes = held.col(3) - held.leftCols<3>() * increment.motion;
    if (!amplitudes.allFinite() || !increment.motion.allFinite())
      throw ContactFailure(ContactOutcome::linear_solver_failed,
                           "The contact system of the body of revolution is singular: the loaded points do "
                           "not support the foot.");
    increment.forces = forces_of(amplitudes.reshaped(p, n_modes), increment.motion);
    return increment;
  }

private:
  /// Range of circles with present or expected forces.
  struct Range
  {
    Eigen::Index first = 0;
    Eigen::Index size = 0;
  };
  /// Lines that are eliminated together, on the union of their circles.
  struct Bundle
  {
    Eigen::Index first_line;
    Range circles;
    /// (1 + T D)^-1 of T times the functions, of T Q and of r: shape [circles.size, n_functions + 3 + 1].
    LaneTable solution;
  };

  void find_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced,
                  double negligible)
  {
    const Eigen::Index n_radii = response.n_radii();
    lines.resize(response.n_lines());
    Eigen::Index last_circle = -1;
    circles.first = n_radii;
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(lines.size()); ++j)
    {
      Range &line = lines[static_cast<std::size_t>(j)];
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
      circles.first = std::min(circles.first, first);
      last_circle = std::max(last_circle, end - 1);
    }
    if (last_circle < 0)
      throw ContactFailure(ContactOutcome::linear_solver_failed,
                           "No point of the contact zone is under pressure.");
    circles.size = last_circle - circles.first + 1;
  }

  void eliminate_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced)
  {
    const Eigen::Index n_radii = response.n_radii(), n_lines = response.n_lines();
    const Eigen::Index n_functions = smooth.values.cols();
    const Eigen::VectorXd &radii = response.compliance().radii;
    const HarmonicCompliance &tail = response.compliance().tail;
    LineBundle system;
    for (Eigen::Index first_line = 0; first_line < n_lines; first_line += Lanes::n)
    {
      const Eigen::Index end_line = std::min(first_line + Lanes::n, n_lines);
      Eigen::Index first = n_radii, end = 0;
      for (Eigen::Index j = first_line; j < end_line; ++j)
        if (const Range &line = lines[static_cast<std::size_t>(j)]; line.size > 0)
        {
          first = std::min(first, line.first);
          end = std::max(end, line.first + line.size);
        }
      if (end <= first)
        continue;
      const Eigen::Index size = end - first, from = first - circles.first;
      system.reset(size, response.compliance().degree, n_functions + 4);
      for (Eigen::Index j = first_line; j < end_line; ++j)
      {
        const int lane = static_cast<int>(j - first_line);
        const double theta = response.basis().azimuth(static_cast<unsigned int>(j));
        for (Eigen::Index i = 0; i < size; ++i)
        {
          if (response.has_sliding())
            system.slide(i, lane) = response.radial_traction()(first + i, j);
          for (Eigen::Index k = 0; k < n_functions; ++k)
            system.shape(i, k, lane) = smooth.values(from + i, k);
          system.shape(i, n_functions, lane) = 1;
          system.shape(i, n_functions + 1, lane) = radii(first + i) * std::cos(theta);
          system.shape(i, n_functions + 2, lane) = radii(first + i) * std::sin(theta);
        }
        const Range &line = lines[static_cast<std::size_t>(j)];
        for (Eigen::Index i = line.first; i < line.first + line.size; ++i)
        {
          system.unbalanced(i - first, lane) = unbalanced(i, j);
          for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, j * n_radii + i); entry; ++entry)
            if (entry.value() != 0)
              system.tangent(entry.row() - j * n_radii - first, i - first, lane) = entry.value();
        }
      }
      const auto local = [&](const Eigen::MatrixXd &matrix) -> RowMatrix
      { return response.lines_per_radian() * matrix.block(first, first, size, size); };
      bundles.push_back(
        { first_line,
          { first, size },
          system.solve(local(tail.normal), response.has_sliding() ? local(tail.radial) : RowMatrix()) });
    }
  }

  SmoothFunctions chosen_functions() const
  {
    const unsigned int n_max = response.basis().n_harmonics();
    const Eigen::VectorXd radii = response.compliance().radii.segment(circles.first, circles.size);
    SmoothFunctions chosen = { circles.first, circles.size, response.has_sliding(), {}, {} };
    std::vector<HarmonicCompliance> differences;
    for (unsigned int n = 0; n <= n_max; ++n)
      differences.push_back(response.difference(n, circles.first, circles.size));
    const Eigen::MatrixXd tail =
      response.compliance().tail.normal.block(circles.first, circles.first, circles.size, circles.size);
    const double allowed = step_accuracy * (tail.norm() + differences[0].normal.norm());
    const Eigen::LLT<Eigen::MatrixXd> factor(tail);
    for (Eigen::Index n_functions = std::min<Eigen::Index>(2, circles.size);; ++n_functions)
    {
      const Eigen::MatrixXd functions = polynomials(radii, n_functions);
      double worst = 0, contraction = 0;
      const auto leave_out = [&](const Eigen::MatrixXd &matrix)
      {
        const Eigen::MatrixXd rest =
          matrix - functions * (functions.transpose() * matrix * functions) * functions.transpose();
        worst = std::max(worst, rest.norm());
        if (n_functions < many_functions)
          return;
        // Contraction factor of an inexact step on a rigid table: |L^-1 rest L^-T|, where L L^T = `tail` is
        // the part of the compliance that the step treats exactly.
        const Eigen::MatrixXd half = factor.matrixL().solve(rest);
        contraction = std::max(contraction, factor.matrixL().solve(half.transpose()).norm());
      };
      for (const unsigned int n : { 0u, 1u, n_max / 2, n_max })
      {
        leave_out(differences[n].normal);
        if (response.has_sliding())
        {
          leave_out(differences[n].radial);
          leave_out(differences[n].azimuthal);
        }
      }
      const bool contracts = n_functions >= many_functions && !(contraction > slowest_contraction);
      if (worst <= allowed || contracts || n_functions >= circles.size)
      {
        const auto reduced = [&](const Eigen::MatrixXd &matrix) -> Eigen::MatrixXd
        { return functions.transpose() * matrix * functions; };
        for (const auto &[normal, radial, azimuthal] : differences)
          chosen.reduced.push_back({ reduced(normal), reduced(radial), reduced(azimuthal) });
        chosen.values = functions;
        return chosen;
      }
    }
  }

  /// Returns the sums over a bundle's circles of the solution times the functions, the functions with
  /// tractions, and @p weights of the conditions; shape [n_kinds n_functions + 3, n_functions + 4].
  LaneTable tested(const Bundle &bundle, const Eigen::MatrixX3d &weights) const
  {
    const Eigen::Index p = smooth.values.cols(), n_radii = response.n_radii(), n_lines = response.n_lines();
    const auto [first, size] = bundle.circles;
    LaneTable tests(size, n_kinds() * p + 3);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = bundle.first_line; j < std::min(bundle.first_line + Lanes::n, n_lines); ++j)
      {
        const int lane = static_cast<int>(j - bundle.first_line);
        for (Eigen::Index kind = 0; kind < n_kinds(); ++kind)
        {
          const double traction = kind == 0   ? 1
                                  : kind == 1 ? response.radial_traction()(first + i, j)
                                              : response.azimuthal_traction()(first + i, j);
          for (Eigen::Index k = 0; k < p; ++k)
            tests(i, kind * p + k, lane) = traction * smooth.values(first - circles.first + i, k);
        }
        for (Eigen::Index a = 0; a < 3; ++a)
          tests(i, n_kinds() * p + a, lane) = weights(j * n_radii + first + i, a);
      }
    return products(tests, bundle.solution);
  }

  /// Returns tested() of each line as a column, row index fastest: a matrix per kind of force with the
  /// responses to p functions, motions and residual, shape [p * (p + 4), n_lines]; last, of the conditions,
  /// shape [3 * (p + 4), n_lines].
  std::vector<Eigen::MatrixXd> sums_on_lines(const LinearConditions &conditions) const
  {
    const Eigen::Index p = smooth.values.cols(), n_lines = response.n_lines(), n_kinds = this->n_kinds();
    std::vector<Eigen::MatrixXd> sums(n_kinds, Eigen::MatrixXd::Zero(p * (p + 4), n_lines));
    sums.emplace_back(Eigen::MatrixXd::Zero(3 * (p + 4), n_lines));
    for (const Bundle &bundle : bundles)
    {
      const LaneTable tests = tested(bundle, conditions.weights());
      for (Eigen::Index j = bundle.first_line; j < std::min(bundle.first_line + Lanes::n, n_lines); ++j)
        for (Eigen::Index kind = 0; kind <= n_kinds; ++kind)
          for (Eigen::Index c = 0, place = 0; c < p + 4; ++c)
            for (Eigen::Index a = 0; a < (kind < n_kinds ? p : 3); ++a, ++place)
              sums[kind](place, j) = tests(kind * p + a, c, static_cast<int>(j - bundle.first_line));
    }
    return sums;
  }

  /// Returns the system of the amplitudes for a fixed table, and the columns of motions and residual: shape
  /// [n_modes * p, n_modes * p + 4].
  RowMatrix system_of_amplitudes(const std::vector<Eigen::MatrixXd> &on_lines) const
  {
    const FourierBasis &basis = response.basis();
    const Eigen::Index p = smooth.values.cols(), n_modes = basis.n_modes(), n = n_modes * p;
    RowMatrix system = RowMatrix::Zero(n, n + 4);
    for (Eigen::Index kind = 0; kind < n_kinds(); ++kind)
    {
      const bool conjugate = kind == 2;
      const FourierProducts products(basis, on_lines[kind].topRows(p * p));
      const auto other_columns = on_lines[kind].bottomRows(p * 4);
      const Eigen::MatrixXd projected =
        conjugate ? basis.project_on_conjugates(other_columns) : basis.project(other_columns);
      Eigen::MatrixXd sums(p, n + 4);
      for (Eigen::Index row = 0; row < n_modes; ++row)
      {
        const auto row_mode = static_cast<unsigned int>(row);
        for (Eigen::Index column = 0; column < n_modes; ++column)
          Eigen::Map<Eigen::VectorXd>(sums.data() + column * p * p, p * p) =
            products(row_mode, static_cast<unsigned int>(column), conjugate);
        sums.rightCols<4>() = projected.col(row).reshaped(p, 4);
        const HarmonicCompliance &harmonic = smooth.reduced[FourierBasis::harmonic(row_mode)];
        const Eigen::MatrixXd weight = (kind == 0   ? harmonic.normal
                                        : kind == 1 ? harmonic.radial
                                                    : harmonic.azimuthal) /
                                       FourierBasis::norm(row_mode);
        system.middleRows(row * p, p).noalias() += weight * sums;
      }
    }
    system.diagonal().array() += 1;
    return system;
  }

  /// Returns df for @p amplitudes, shape [p, n_modes], and the table @p motion.
  Eigen::MatrixXd forces_of(const Eigen::MatrixXd &amplitudes, const Eigen::Vector3d &motion) const
  {
    const Eigen::Index p = smooth.values.cols(), n_lines = response.n_lines();
    const Eigen::MatrixXd on_lines = response.basis().evaluate(amplitudes); // shape [p, n_lines]
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(response.n_radii(), n_lines);
    for (const Bundle &bundle : bundles)
      for (Eigen::Index j = bundle.first_line; j < std::min(bundle.first_line + Lanes::n, n_lines); ++j)
        for (Eigen::Index i = 0; i < bundle.circles.size; ++i)
        {
          const auto part = [&](Eigen::Index c)
          { return bundle.solution(i, c, static_cast<int>(j - bundle.first_line)); };
          double &force = forces(bundle.circles.first + i, j);
          force = part(p + 3);
          for (Eigen::Index k = 0; k < p; ++k)
            force -= part(k) * on_lines(k, j);
          for (Eigen::Index k = 0; k < 3; ++k)
            force -= part(p + k) * motion(k);
        }
    return forces;
  }

  /// Returns the number of kinds of force: normal, radial and azimuthal, or normal only.
  Eigen::Index n_kinds() const { return response.has_sliding() ? 3 : 1; }

  const ElasticResponse &response;
  std::vector<Range> lines;
  std::vector<Bundle> bundles;
  Range circles; ///< circles of all lines together
  const SmoothFunctions &smooth;
};

} // namespace

LineIncrement line_newton_step(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
                               const Eigen::MatrixXd &unbalanced, double negligible,
                               const LinearConditions &conditions, const Eigen::Vector3d &residual,
                               SmoothFunctions &cached)
{
  return LineNewton(response, tangent, unbalanced, cached, negligible).solve(conditions, residual);
}

} // namespace stemware::fem
