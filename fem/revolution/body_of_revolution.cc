#include "fem/revolution/body_of_revolution.h"

#include "fem/contact/line_integral.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

BodyOfRevolution::BodyOfRevolution(ContactCompliance compliance_given, const Gap &gap, unsigned int n_lines)
    : response(std::move(compliance_given), n_lines)
{
  make_lines();
  set_gap(gap);
  reset();
}

void BodyOfRevolution::make_lines()
{
  const ContactCompliance &circles = response.compliance();
  const unsigned int n_radii = circles.n_nodes();
  const unsigned int degree = circles.degree;
  const unsigned int n_pieces = degree > 2 ? 2 : 1;
  const double width = FourierBasis::norm(0) / response.basis().n_lines();
  surface.lines_are_radial = true;
  surface.n_sectors = response.basis().n_lines();
  surface.node_position.resize(n_radii * response.basis().n_lines(), 2);
  surface.node_area = Eigen::VectorXd::Zero(n_radii * response.basis().n_lines());
  for (unsigned int j = 0; j < response.basis().n_lines(); ++j)
  {
    const Eigen::RowVector2d outward(response.basis().cosine(1, j), response.basis().sine(1, j));
    const Eigen::RowVector2d across(-outward(1), outward(0));
    for (unsigned int i = 0; i < n_radii; ++i)
      surface.node_position.row(j * n_radii + i) = circles.radii(i) * outward;
    for (unsigned int first = 0; first + degree < n_radii; first += degree)
      for (unsigned int piece = 0; piece < n_pieces; ++piece)
      {
        const Eigen::VectorXd nodes = circles.radii.segment(first, degree + 1);
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
        line.azimuth = response.basis().azimuth(j);
        line.azimuth_width = width;
        add_node_areas(line, surface.node_area);
        surface.lines.push_back(std::move(line));
      }
  }
  const std::size_t n_pieces_of_line = surface.lines.size() / response.basis().n_lines();
  for (std::size_t j = 0; j < response.basis().n_lines(); ++j)
    for (std::size_t piece = 0; piece < n_pieces_of_line; ++piece)
      surface.mirrored_lines.push_back(
        (response.basis().n_lines() - j) % response.basis().n_lines() * n_pieces_of_line + piece);
}

void BodyOfRevolution::set_gap(const Gap &gap)
{
  const ContactCompliance &circles = response.compliance();
  const unsigned int n_radii = circles.n_nodes();
  surface.node_gap.resize(n_radii * response.basis().n_lines());
  for (unsigned int j = 0; j < response.basis().n_lines(); ++j)
    for (unsigned int i = 0; i < n_radii; ++i)
      surface.node_gap(j * n_radii + i) = gap(circles.radii(i), response.basis().azimuth(j));
  for (ContactLine &line : surface.lines)
    for (unsigned int sample = 0; sample < 3; ++sample)
      line.gap(sample) = gap(line.position.row(sample).norm(), line.azimuth);
}

void BodyOfRevolution::set_sliding(const std::optional<SlidingTraction> &traction)
{
  response.set_sliding(traction);
  displacement = response.displacement(state);
}

NewtonIncrement BodyOfRevolution::solve(const Eigen::SparseMatrix<double> &tangent,
                                        const Eigen::VectorXd &forces, const LinearConditions &conditions,
                                        const Eigen::Vector3d &motion)
{
  const Eigen::MatrixXd unbalanced = forces.reshaped(state.rows(), state.cols()) - state;
  // Of the largest force: what rounding leaves where a contact has gone.
  const double negligible = 1e-13 * forces.cwiseAbs().maxCoeff();
  const LineNewton newton(response, tangent, unbalanced, functions, negligible);
  const LineNewton::Increment found = newton.solve(conditions, conditions.residual(state.reshaped(), motion));
  increment = found.forces;
  last_resistance = found.resistance;
  moved = response.displacement(increment);
  NewtonIncrement step;
  step.displacement = moved.reshaped();
  step.motion = found.motion;
  step.energy_slope = moved.cwiseProduct(state).sum();
  step.energy_curvature = moved.cwiseProduct(increment).sum();
  return step;
}

void BodyOfRevolution::update(double step_length)
{
  state += step_length * increment;
  displacement += step_length * moved;
}

void BodyOfRevolution::set_forces(const Eigen::VectorXd &forces)
{
  state = forces.reshaped(state.rows(), state.cols());
  displacement = response.displacement(state);
}

Eigen::Vector3d BodyOfRevolution::motion_of_circle(Eigen::Index i) const
{
  const Eigen::RowVectorXd modes = response.basis().project(displacement.row(i)) * (2. / response.n_lines());
  const double radius = response.compliance().radii(i);
  return { modes(0) / 2, modes(1) / radius, modes(2) / radius };
}

void BodyOfRevolution::reset()
{
  state = displacement = Eigen::MatrixXd::Zero(response.n_radii(), response.n_lines());
}

double BodyOfRevolution::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return (forces - state.reshaped()).norm() / forces.norm();
}

unsigned int BodyOfRevolution::n_unknowns() const
{
  return response.n_radii() * response.n_lines() + 3;
}

} // namespace stemware::fem
