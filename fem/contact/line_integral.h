#pragma once

#include "fem/contact/contact_surface.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Returns the quadratic Lagrange polynomials of the nodes -1, 0, 1 at @p xi.
inline Eigen::Vector3d line_shape(double xi)
{
  return { xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2 };
}

/// Part of a contact line, within [-1, 1].
struct LineSegment
{
  double begin = 0;
  double end = 0;
};

/// Segments (at most two) of [-1, 1] on which the quadratic through @p samples (at -1, 0, 1) is positive.
struct PositiveSegments
{
  explicit PositiveSegments(const Eigen::Vector3d &samples);
  std::array<LineSegment, 2> segments;
  unsigned int n_segments = 0;
};

/// Returns the coefficients of the quadratic through @p samples: c(0) + c(1) xi + c(2) xi^2.
inline Eigen::Vector3d quadratic_through(const Eigen::Vector3d &samples)
{
  return { samples(1), (samples(2) - samples(0)) / 2, (samples(0) + samples(2)) / 2 - samples(1) };
}

/// Returns the value of the quadratic with @p coefficients at @p xi.
inline double value_at(const Eigen::Vector3d &coefficients, double xi)
{
  return coefficients(0) + xi * (coefficients(1) + xi * coefficients(2));
}

/// Quadrature point on a loaded segment.
struct LinePoint
{
  double xi = 0;   ///< local coordinate
  double area = 0; ///< weight: table area, > 0 [m^2]
};

/// Table area per local coordinate of a contact line, |d(x, y)/dxi x transverse tangent|: a cubic.
class AreaElement
{
public:
  explicit AreaElement(const ContactLine &line)
  {
    const Eigen::Vector3d x = quadratic_through(line.position.col(0)),
                          y = quadratic_through(line.position.col(1)),
                          across_x = quadratic_through(line.transverse_tangent.col(0)),
                          across_y = quadratic_through(line.transverse_tangent.col(1));
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      cubic(i) += x(1) * across_y(i) - y(1) * across_x(i);
      cubic(i + 1) += 2 * (x(2) * across_y(i) - y(2) * across_x(i));
    }
  }

  /// Returns the area element at @p xi [m^2].
  double operator()(double xi) const
  {
    return std::abs(cubic(0) + xi * (cubic(1) + xi * (cubic(2) + xi * cubic(3))));
  }

private:
  Eigen::Vector4d cubic = Eigen::Vector4d::Zero();
};

/// Returns the part @p range of @p line, without nodes, and its samples' depth, from @p depth of @p line.
inline std::pair<ContactLine, Eigen::Vector3d> part_of(const ContactLine &line, const Eigen::Vector3d &depth,
                                                       const LineSegment &range)
{
  Eigen::Matrix3d at_samples; // [sample of the part, sample of the line]
  at_samples << line_shape(range.begin).transpose(), line_shape((range.begin + range.end) / 2).transpose(),
    line_shape(range.end).transpose();
  ContactLine part;
  part.position = at_samples * line.position;
  part.transverse_tangent = at_samples * line.transverse_tangent;
  part.gap = at_samples * line.gap;
  return { part, at_samples * depth };
}

/// Gauss quadrature on [-1, 1] with an even number of points: positive abscissas and their weights.
template <unsigned int n_points>
struct GaussRule
{
  static const std::vector<double> abscissas, weights;
};
extern template struct GaussRule<2>;
extern template struct GaussRule<4>;
extern template struct GaussRule<6>;

/// Calls visit(const LinePoint &) at the @p n_points Gauss points (an even number) of a segment; exact for
/// degree 2 n_points - 1 in the local coordinate, area element included.
template <unsigned int n_points = 4, typename Visitor>
void for_each_point(const AreaElement &area, const LineSegment &segment, const Visitor &visit)
{
  using Rule = GaussRule<n_points>;
  const double middle = (segment.begin + segment.end) / 2, half_length = (segment.end - segment.begin) / 2;
  for (const double side : { -1., 1. })
    for (std::size_t q = 0; q < n_points / 2; ++q)
    {
      const double xi = middle + side * half_length * Rule::abscissas[q];
      visit(LinePoint{ xi, area(xi) * half_length * Rule::weights[q] });
    }
}

/// Calls visit(const LinePoint &) at the four Gauss points of every segment with positive @p penetration:
/// exact for a product of two quadratics and the cubic area element.
template <typename Visitor>
void for_each_loaded_point(const AreaElement &area, const Eigen::Vector3d &penetration, const Visitor &visit)
{
  const PositiveSegments loaded(penetration);
  for (unsigned int s = 0; s < loaded.n_segments; ++s)
    for_each_point(area, loaded.segments[s], visit);
}

/// Returns the penetration at the samples of @p line [m]. @p normal_displacement: as in TableLaw.
inline Eigen::Vector3d penetration(const ContactLine &line, const Eigen::VectorXd &normal_displacement)
{
  Eigen::Vector3d depth = -line.gap;
  if (line.samples_are_nodes)
  {
    for (unsigned int i = 0; i < 3; ++i)
      depth(i) -= normal_displacement(line.nodes[i]);
    return depth;
  }
  for (unsigned int i = 0; i < line.nodes.size(); ++i)
    depth -= line.shape.col(i) * normal_displacement(line.nodes[i]);
  return depth;
}

/// Adds the contribution of @p line to int N_i dA of its nodes, ContactSurface::node_area [m^2].
inline void add_node_areas(const ContactLine &line, Eigen::VectorXd &node_area)
{
  for_each_point(AreaElement(line), LineSegment{ -1, 1 },
                 [&](const LinePoint &point)
                 {
                   const Eigen::Vector3d shape = line_shape(point.xi);
                   for (unsigned int i = 0; i < line.nodes.size(); ++i)
                     node_area(line.nodes[i]) += point.area * line.shape.col(i).dot(shape);
                 });
}

} // namespace stemware::fem
