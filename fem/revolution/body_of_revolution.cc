#include "fem/revolution/body_of_revolution.h"

#include "fem/contact/line_integral.h"
#include "ring_model/load/lagrange.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

/// Contact line of an element or of half an element; equal at all azimuths.
struct Piece
{
  unsigned int first; ///< number of the element's first circle
  Eigen::Vector3d radii;
  Eigen::Matrix<double, 3, Eigen::Dynamic> shape;
};

std::vector<Piece> pieces_of(const ContactCompliance &circles)
{
  const unsigned int degree = circles.degree, n_pieces = degree > 2 ? 2 : 1;
  std::vector<Piece> pieces;
  for (unsigned int first = 0; first + degree < circles.n_nodes(); first += degree)
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
  return pieces;
}

} // namespace

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
  const double width = FourierBasis::norm(0) / n_lines;
  const std::vector<Piece> pieces = pieces_of(circles);
  const auto result = std::make_shared<ContactSurface>();
  result->lines_are_radial = true;
  result->n_sectors = n_lines;
  result->node_position.resize(n_radii * n_lines, 2);
  result->lines.reserve(n_lines * pieces.size());
  result->mirrored_lines.reserve(n_lines * pieces.size());
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    const Eigen::RowVector2d outward(basis.cosine_table()(j, 1), basis.sine_table()(j, 1));
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
  set_forces(state);
}

Eigen::VectorXd BodyOfRevolution::response_to(const Eigen::VectorXd &forces) const
{
  return response.displacement(on_lines(forces)).reshaped();
}

NewtonIncrement BodyOfRevolution::solve(const Eigen::SparseMatrix<double> &tangent,
                                        const Eigen::VectorXd &forces, const LinearConditions &conditions,
                                        const Eigen::Vector3d &motion)
{
  const Eigen::MatrixXd unbalanced = on_lines(forces - state);
  // Smaller forces are rounding errors at points that have lost contact.
  const double negligible = 1e-13 * forces.cwiseAbs().maxCoeff();
  const LineIncrement found = line_newton_step(response, tangent, unbalanced, negligible, conditions,
                                               conditions.residual(state, motion), functions);
  return step_by(found.forces.reshaped(), found.motion, found.resistance, conditions);
}

Eigen::Vector3d BodyOfRevolution::motion_of_circle(Eigen::Index i) const
{
  const Eigen::RowVectorXd modes =
    response.basis().project(on_lines(displacement).row(i)) * (2. / response.n_lines());
  const double radius = response.compliance().radii(i);
  return { modes(0) / 2, modes(1) / radius, modes(2) / radius };
}

} // namespace stemware::fem
