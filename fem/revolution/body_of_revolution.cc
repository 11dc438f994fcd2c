#include "fem/revolution/body_of_revolution.h"

#include "fem/contact/line_integral.h"
#include "fem/revolution/harmonic_newton.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

/// Circles whose force is more than rounding of the largest.
std::vector<bool> loaded_circles(const Eigen::MatrixXd &modes)
{
  const Eigen::VectorXd sizes = modes.rowwise().norm();
  const double threshold = 1e-14 * sizes.maxCoeff();
  std::vector<bool> loaded(static_cast<std::size_t>(modes.rows()));
  for (std::size_t i = 0; i < loaded.size(); ++i)
    loaded[i] = sizes(static_cast<Eigen::Index>(i)) > threshold;
  return loaded;
}

/// What is odd in theta counts as rounding below this share.
constexpr double symmetry_tolerance = 1e-11;

} // namespace

BodyOfRevolution::BodyOfRevolution(ContactCompliance compliance_given, const Gap &gap, unsigned int n_lines)
    : compliance(std::move(compliance_given))
    , basis(compliance.n_harmonics(), n_lines)
{
  make_lines();
  set_gap(gap);
  reset();
}

void BodyOfRevolution::make_lines()
{
  const unsigned int n_radii = compliance.n_nodes();
  const unsigned int degree = compliance.degree;
  const unsigned int n_pieces = degree > 2 ? 2 : 1;
  const double width = FourierBasis::norm(0) / basis.n_lines();
  surface.lines_are_radial = true;
  surface.n_sectors = basis.n_lines();
  surface.node_position.resize(n_radii * basis.n_lines(), 2);
  surface.node_area = Eigen::VectorXd::Zero(n_radii * basis.n_lines());
  for (unsigned int j = 0; j < basis.n_lines(); ++j)
  {
    const Eigen::RowVector2d outward(basis.cosine(1, j), basis.sine(1, j));
    const Eigen::RowVector2d across(-outward(1), outward(0));
    for (unsigned int i = 0; i < n_radii; ++i)
      surface.node_position.row(j * n_radii + i) = compliance.radii(i) * outward;
    for (unsigned int first = 0; first + degree < n_radii; first += degree)
      for (unsigned int piece = 0; piece < n_pieces; ++piece)
      {
        const Eigen::VectorXd nodes = compliance.radii.segment(first, degree + 1);
        const double length = (nodes(degree) - nodes(0)) / n_pieces;
        ContactLine line;
        line.shape.resize(3, degree + 1);
        for (unsigned int i = 0; i <= degree; ++i)
          line.nodes.push_back(j * n_radii + first + i);
        for (unsigned int sample = 0; sample < 3; ++sample)
        {
          const double radius = nodes(0) + length * (piece + sample / 2.);
          line.shape.row(sample) = lagrange_values(nodes, radius);
          line.position.row(sample) = radius * outward;
          line.transverse_tangent.row(sample) = radius * width * across;
        }
        line.samples_are_nodes = degree == 2;
        if (line.samples_are_nodes)
          line.shape.setIdentity(); // to the last bit
        line.azimuth = basis.azimuth(j);
        line.azimuth_width = width;
        add_node_areas(line, surface.node_area);
        surface.lines.push_back(std::move(line));
      }
  }
  const std::size_t n_pieces_of_line = surface.lines.size() / basis.n_lines();
  for (std::size_t j = 0; j < basis.n_lines(); ++j)
    for (std::size_t piece = 0; piece < n_pieces_of_line; ++piece)
      surface.mirrored_lines.push_back((basis.n_lines() - j) % basis.n_lines() * n_pieces_of_line + piece);
}

void BodyOfRevolution::set_gap(const Gap &gap)
{
  const unsigned int n_radii = compliance.n_nodes();
  surface.node_gap.resize(n_radii * basis.n_lines());
  for (unsigned int j = 0; j < basis.n_lines(); ++j)
    for (unsigned int i = 0; i < n_radii; ++i)
      surface.node_gap(j * n_radii + i) = gap(compliance.radii(i), basis.azimuth(j));
  for (ContactLine &line : surface.lines)
    for (unsigned int sample = 0; sample < 3; ++sample)
      line.gap(sample) = gap(line.position.row(sample).norm(), line.azimuth);
}

void BodyOfRevolution::set_sliding(const std::optional<SlidingTraction> &traction)
{
  projected_forces.resize(0);
  projection = {};
  if (!traction || traction->friction_coefficient == 0)
  {
    slide_radial.resize(0, 0);
    slide_azimuthal.resize(0, 0);
    state.radial.resize(0, 0);
    state.azimuthal.resize(0, 0);
    return;
  }
  traction->validate();
  slide_radial.resize(compliance.n_nodes(), basis.n_lines());
  slide_azimuthal.resize(compliance.n_nodes(), basis.n_lines());
  for (unsigned int j = 0; j < basis.n_lines(); ++j)
    for (unsigned int i = 0; i < compliance.n_nodes(); ++i)
    {
      const Eigen::Vector2d direction = traction->direction(compliance.radii(i), basis.azimuth(j));
      slide_radial(i, j) = direction(0);
      slide_azimuthal(i, j) = direction(1);
    }
  if (state.radial.size() == 0)
    state.radial = state.azimuthal = Eigen::MatrixXd::Zero(state.normal.rows(), state.normal.cols());
}

const ForceModes &BodyOfRevolution::modes_of(const Eigen::VectorXd &forces) const
{
  // The driver asks for the balance of the same forces that it then hands to solve().
  if (projected_forces.size() == forces.size() && projected_forces == forces)
    return projection;
  projected_forces = forces;
  const Eigen::Map<const Eigen::MatrixXd> on_lines(forces.data(), compliance.n_nodes(), basis.n_lines());
  projection.normal = basis.project(on_lines);
  if (has_sliding())
  {
    projection.radial = basis.project(on_lines.cwiseProduct(slide_radial));
    projection.azimuthal = basis.project_on_conjugates(on_lines.cwiseProduct(slide_azimuthal));
  }
  return projection;
}

ForceModes BodyOfRevolution::residual(const Eigen::VectorXd &forces) const
{
  ForceModes result = modes_of(forces);
  result.normal -= state.normal;
  if (has_sliding())
  {
    result.radial -= state.radial;
    result.azimuthal -= state.azimuthal;
  }
  return result;
}

Eigen::MatrixXd BodyOfRevolution::displacement_modes(const ForceModes &forces) const
{
  Eigen::MatrixXd displacement(compliance.n_nodes(), basis.n_modes());
  for (unsigned int mode = 0; mode < basis.n_modes(); ++mode)
  {
    const HarmonicCompliance &harmonic = compliance.harmonics[FourierBasis::harmonic(mode)];
    displacement.col(mode) = harmonic.normal * forces.normal.col(mode);
    if (forces.radial.size() > 0)
      displacement.col(mode) +=
        harmonic.radial * forces.radial.col(mode) + harmonic.azimuthal * forces.azimuthal.col(mode);
    displacement.col(mode) /= FourierBasis::norm(mode);
  }
  return displacement;
}

Eigen::VectorXd BodyOfRevolution::contact_displacement() const
{
  return basis.evaluate(displacement_modes(state)).reshaped();
}

bool BodyOfRevolution::is_even(const LineTangents &tangents, const Eigen::VectorXd &forces,
                               const LinearConditions &conditions) const
{
  if (has_sliding() || !conditions.are_resultants())
    return false;
  const double allowed = symmetry_tolerance * forces.lpNorm<1>();
  double odd = std::abs(conditions.residual(forces)(2)) / compliance.radii(0);
  const Eigen::Map<const Eigen::MatrixXd> on_lines(forces.data(), compliance.n_nodes(), basis.n_lines());
  const Eigen::Index n_lines = basis.n_lines();
  for (Eigen::Index line = 1; 2 * line < n_lines; ++line)
    odd = std::max(odd, (on_lines.col(line) - on_lines.col(n_lines - line)).cwiseAbs().maxCoeff());
  for (unsigned int mode = 2; mode < basis.n_modes(); mode += 2)
    odd = std::max(odd, state.normal.col(mode).cwiseAbs().maxCoeff());
  return odd <= allowed && tangents.is_even(symmetry_tolerance);
}

ModeMatrix BodyOfRevolution::on_circles(const Eigen::MatrixXd &whole, const LineTangents &tangents,
                                        const std::vector<unsigned int> &modes) const
{
  ModeMatrix part(tangents.circles.size(), modes.size());
  for (std::size_t k = 0; k < modes.size(); ++k)
    for (std::size_t p = 0; p < tangents.circles.size(); ++p)
      part(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(k)) = whole(tangents.circles[p], modes[k]);
  return part;
}

NewtonConditions BodyOfRevolution::in_modes(const LinearConditions &conditions,
                                            const Eigen::SparseMatrix<double> &tangent,
                                            const Eigen::VectorXd &forces, const LineTangents &tangents,
                                            const std::vector<unsigned int> &modes) const
{
  NewtonConditions result;
  result.residual = conditions.residual(forces);
  if (conditions.are_resultants())
    return result;
  const Eigen::MatrixX3d change = tangent * conditions.weights(); // T L
  const auto n_unknowns = static_cast<Eigen::Index>(tangents.circles.size() * modes.size());
  result.rows.emplace(3, n_unknowns);
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const Eigen::Map<const Eigen::MatrixXd> on_lines(change.col(i).data(), compliance.n_nodes(),
                                                     basis.n_lines());
    const ModeMatrix row = on_circles(basis.project(on_lines), tangents, modes);
    result.rows->row(i) = row.reshaped().transpose();
  }
  result.corner = change.transpose() * surface.motion_modes();
  return result;
}

NewtonIncrement BodyOfRevolution::solve(const Eigen::SparseMatrix<double> &tangent,
                                        const Eigen::VectorXd &forces, const LinearConditions &conditions)
{
  ForceModes unbalanced = residual(forces);
  const LineTangents tangents(tangent, compliance.n_nodes(), basis.n_lines(),
                              loaded_circles(unbalanced.normal));
  const bool even = is_even(tangents, forces, conditions);
  // What is odd in an even state is rounding: the step takes it away.
  if (even)
    for (unsigned int mode = 2; mode < basis.n_modes(); mode += 2)
      unbalanced.normal.col(mode) = -state.normal.col(mode);
  HarmonicNewton newton(basis, compliance, tangents, even);
  const std::vector<unsigned int> &modes = newton.modes();
  ModeMatrix rhs = on_circles(unbalanced.normal, tangents, modes);
  if (has_sliding())
  {
    newton.add_sliding(slide_radial, slide_azimuthal);
    ForceModes tangential = unbalanced;
    tangential.normal.setZero();
    rhs += newton.stiffness_times(on_circles(displacement_modes(tangential), tangents, modes));
  }
  const HarmonicNewton::Result result =
    newton.solve(rhs, in_modes(conditions, tangent, forces, tangents, modes));

  increment = unbalanced;
  const auto subtract = [&](Eigen::MatrixXd &force, const ModeMatrix &decrement)
  {
    for (std::size_t k = 0; k < modes.size(); ++k)
      for (std::size_t p = 0; p < tangents.circles.size(); ++p)
        force(tangents.circles[p], modes[k]) -=
          decrement(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(k));
  };
  subtract(increment.normal, result.normal_decrement);
  if (has_sliding())
  {
    subtract(increment.radial, result.radial_decrement);
    subtract(increment.azimuthal, result.azimuthal_decrement);
  }
  const Eigen::MatrixXd displacement = displacement_modes(increment);
  NewtonIncrement step;
  step.displacement = basis.evaluate(displacement).reshaped();
  step.motion = result.motion;
  step.energy_slope = displacement.cwiseProduct(state.normal).sum();
  step.energy_curvature = displacement.cwiseProduct(increment.normal).sum();
  return step;
}

void BodyOfRevolution::update(double step_length)
{
  state.normal += step_length * increment.normal;
  if (has_sliding())
  {
    state.radial += step_length * increment.radial;
    state.azimuthal += step_length * increment.azimuthal;
  }
}

void BodyOfRevolution::reset()
{
  state.normal = Eigen::MatrixXd::Zero(compliance.n_nodes(), basis.n_modes());
  if (has_sliding())
    state.radial = state.azimuthal = state.normal;
}

double BodyOfRevolution::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  const ForceModes &needed = modes_of(forces);
  double difference = (needed.normal - state.normal).squaredNorm();
  double size = needed.normal.squaredNorm();
  if (has_sliding())
  {
    difference +=
      (needed.radial - state.radial).squaredNorm() + (needed.azimuthal - state.azimuthal).squaredNorm();
    size += needed.radial.squaredNorm() + needed.azimuthal.squaredNorm();
  }
  return std::sqrt(difference / size);
}

unsigned int BodyOfRevolution::n_unknowns() const
{
  return compliance.n_nodes() * basis.n_modes() + 3;
}

} // namespace stemware::fem
