#include "fem/revolution/body_of_revolution.h"

#include "fem/contact/line_integral.h"
#include "ring_model/load/lagrange.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

BodyOfRevolution::BodyOfRevolution(ContactCompliance compliance_given, const Gap &gap, unsigned int n_lines)
    : response(std::move(compliance_given), n_lines)
    , surface(lines())
{
  set_gap(gap);
  reset();
}

std::shared_ptr<ContactSurface> BodyOfRevolution::lines() const
{
  const ContactCompliance &circles = response.compliance();
  const FourierBasis &basis = response.basis();
  const unsigned int n_radii = circles.n_nodes(), n_lines = basis.n_lines(), degree = circles.degree;
  const unsigned int n_pieces = degree > 2 ? 2 : 1;
  const double width = FourierBasis::norm(0) / n_lines;
  // Contact line of an element or of half an element; equal at all azimuths.
  struct Piece
  {
    unsigned int first;
    Eigen::Vector3d radii;
    Eigen::Matrix<double, 3, Eigen::Dynamic> shape;
  };
  std::vector<Piece> pieces;
  for (unsigned int first = 0; first + degree < n_radii; first += degree)
    for (unsigned int piece = 0; piece < n_pieces; ++piece)
    {
      const Eigen::VectorXd nodes = circles.radii.segment(first, degree + 1);
      const double length = (nodes(degree) - nodes(0)) / n_pieces;
      Piece &added = pieces.emplace_back(Piece{ first, {}, Eigen::MatrixXd::Identity(3, degree + 1) });
      for (unsigned int sample = 0; sample < 3; ++sample)
      {
        added.radii(sample) = nodes(0) + length * (piece + sample / 2.);
        if (degree != 2) // if the degree is 2, the samples coincide with the nodes
          added.shape.row(sample) = ring::lagrange_values(nodes, added.radii(sample));
      }
    }

  const auto result = std::make_shared<ContactSurface>();
  result->lines_are_radial = true;
  result->n_sectors = n_lines;
  result->node_position.resize(n_radii * n_lines, 2);
  result->lines.reserve(n_lines * pieces.size());
  result->mirrored_lines.reserve(n_lines * pieces.size());
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    const Eigen::RowVector2d outward(basis.cosine(1, j), basis.sine(1, j));
    const Eigen::RowVector2d across(-outward(1), outward(0));
    for (unsigned int i = 0; i < n_radii; ++i)
      result->node_position.row(j * n_radii + i) = circles.radii(i) * outward;
    for (const Piece &piece : pieces)
    {
      ContactLine &line = result->lines.emplace_back();
      for (unsigned int i = 0; i <= degree; ++i)
        line.nodes.push_back(j * n_radii + piece.first + i);
      line.shape = piece.shape;
      line.samples_are_nodes = degree == 2;
      line.position = piece.radii * outward;
      line.transverse_tangent = piece.radii * width * across;
      line.azimuth = basis.azimuth(j);
      line.azimuth_width = width;
      const std::size_t place = result->mirrored_lines.size() - j * pieces.size();
      result->mirrored_lines.push_back((n_lines - j) % n_lines * pieces.size() + place);
    }
  }
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(n_radii * n_lines);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    add_node_areas(result->lines[piece], areas);
  result->node_area = areas.head(n_radii).replicate(n_lines, 1);
  return result;
}

void BodyOfRevolution::set_gap(const Gap &gap)
{
  const ContactCompliance &circles = response.compliance();
  const unsigned int n_radii = circles.n_nodes();
  surface->node_gap.resize(n_radii * response.basis().n_lines());
  for (unsigned int j = 0; j < response.basis().n_lines(); ++j)
    for (unsigned int i = 0; i < n_radii; ++i)
      surface->node_gap(j * n_radii + i) = gap(circles.radii(i), response.basis().azimuth(j));
  for (ContactLine &line : surface->lines)
    for (unsigned int sample = 0; sample < 3; ++sample)
      line.gap(sample) = gap(line.position.row(sample).norm(), line.azimuth);
  // Along a line, waviness changes the gap at most linearly. A nonzero second difference means a crown.
  const ContactLine &line = surface->lines.front();
  const double bulge = line.gap(0) - 2 * line.gap(1) + line.gap(2);
  surface->is_crowned = std::abs(bulge) > 1e-12 * line.position.row(1).norm();
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
  // Smaller forces are rounding errors at points that have lost contact.
  const double negligible = 1e-13 * forces.cwiseAbs().maxCoeff();
  const LineNewton newton(response, tangent, unbalanced, functions, negligible);
  const LineNewton::Increment found = newton.solve(conditions, conditions.residual(state.reshaped(), motion));
  increment = found.forces;
  moved = response.displacement(increment);
  NewtonIncrement step;
  step.displacement = moved.reshaped();
  step.motion = found.motion;
  step.stability_margin =
    (found.resistance - conditions.motion_weights()).determinant() / found.resistance.determinant();
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
