#pragma once

#include "fem/contact/interface_law.h"
#include "fem/contact/line_integral.h"
#include "fem/contact/line_pattern.h"
#include "fem/contact/table_law.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace stemware::fem
{

/// A table whose pressure depends on the local penetration alone, integrated along the contact lines.
///
/// @p Pressure offers, for a penetration d [m], `pressure(d)` [Pa], not decreasing, and `stiffness(d)` =
/// dp/dd [Pa/m]; `has_edge()` as InterfaceLaw; `integrate(line, depth, visit)`, which calls visit(const
/// LinePoint &) at the quadrature points of a line that carry load; and `least_depth(deepest)`, below which a
/// place carries nothing that counts where another one has the penetration `deepest` [m].
template <typename Pressure>
class PressureLaw : public TableLaw
{
public:
  /// Keeps a reference to @p surface.
  PressureLaw(const ContactSurface &surface, const Pressure &pressure)
      : surface(surface)
      , pattern(surface)
      , law(pressure)
  {
  }

  void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const override
  {
    contact.forces.setZero(surface.n_nodes());
    pattern.set_zero(contact.tangent);
    contact.active_set.assign(surface.lines.size(), false);
    const std::vector<Eigen::Vector3d> depths = penetrations(normal_displacement);
    const double least = least_depth(depths);
    for (std::size_t l = 0; l < surface.lines.size(); ++l)
    {
      if (greatest(depths[l]) < least)
        continue;
      const std::size_t image = mirror_image(l, normal_displacement);
      if (image >= l) // else the two are done
        add_line(l, image, depths[l], contact);
    }
  }

  TableLoad load(const ContactSolution &solution, unsigned int n_parts) const override
  {
    TableLoad result;
    result.parts = surface.parts;
    std::vector<double> line_forces;
    line_forces.reserve(surface.lines.size());
    const std::vector<Eigen::Vector3d> depths = penetrations(solution.normal_displacement);
    const double least = least_depth(depths);
    for (std::size_t l = 0; l < surface.lines.size(); ++l)
    {
      double line_force = 0;
      const auto add = [&](const ContactLine &line, const Eigen::Vector3d &depth)
      {
        if (greatest(depth) < least)
          return;
        law.integrate(line, depth,
                      [&](const LinePoint &point)
                      {
                        const double force = law.pressure(point.shape.dot(depth)) * point.area;
                        result.points.push_back({ point.position(0), point.position(1), force });
                        line_force += force;
                      });
      };
      if (n_parts == 1)
        add(surface.lines[l], depths[l]);
      for (unsigned int i = 0; n_parts > 1 && i < n_parts; ++i)
      {
        const auto [part, depth] =
          part_of(surface.lines[l], depths[l], { 2. * i / n_parts - 1, 2. * (i + 1) / n_parts - 1 });
        add(part, depth);
      }
      line_forces.push_back(line_force);
    }
    for (Eigen::Index i = 0; i < solution.beyond_law.size(); ++i)
      if (const double force = solution.beyond_law(i); force != 0)
        result.points.push_back({ surface.node_position(i, 0), surface.node_position(i, 1), force });
    result.density = density_of_lines(surface, line_forces);
    return result;
  }

  PressureMap pressure_map(const ContactSolution &solution) const override
  {
    PressureMap map = pressure_map_of_lines(surface, solution.normal_displacement,
                                            [this](double depth) { return law.pressure(depth); });
    map.has_edge = law.has_edge();
    return map;
  }

  Eigen::VectorXd nodal_pressure(const ContactSolution &solution) const override
  {
    return (-(surface.node_gap + solution.normal_displacement))
      .unaryExpr([this](double depth) { return law.pressure(depth); });
  }

  std::optional<double> pressure_at(double penetration) const override { return law.pressure(penetration); }

private:
  std::vector<Eigen::Vector3d> penetrations(const Eigen::VectorXd &normal_displacement) const
  {
    std::vector<Eigen::Vector3d> depths;
    depths.reserve(surface.lines.size());
    for (const ContactLine &line : surface.lines)
      depths.push_back(penetration(line, normal_displacement));
    return depths;
  }

  /// Upper bound of the penetration on a line: a quadratic lies below its control points.
  static double greatest(const Eigen::Vector3d &depth)
  {
    return std::max({ depth(0), depth(2), 2 * depth(1) - (depth(0) + depth(2)) / 2 });
  }

  double least_depth(const std::vector<Eigen::Vector3d> &depths) const
  {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d &depth : depths)
      deepest = std::max(deepest, depth.maxCoeff());
    return law.least_depth(surface.parts.max(deepest));
  }

  /// The line that has the geometry, gap and normal displacement of line @p l mirrored at y = 0, to the last
  /// bit; @p l itself if there is none.
  std::size_t mirror_image(std::size_t l, const Eigen::VectorXd &normal_displacement) const
  {
    if (surface.mirrored_lines.empty())
      return l;
    const std::size_t image = surface.mirrored_lines[l];
    const ContactLine &line = surface.lines[l];
    const ContactLine &mirrored = surface.lines[image];
    bool alike = line.gap == mirrored.gap;
    for (std::size_t i = 0; alike && i < line.nodes.size(); ++i)
      alike = normal_displacement(line.nodes[i]) == normal_displacement(mirrored.nodes[i]);
    return alike ? image : l;
  }

  /// Adds the forces and the tangent of line @p l, which is pressed in by @p depth, to its nodes, and to
  /// those of its @p image if that is another one.
  void add_line(std::size_t l, std::size_t image, const Eigen::Vector3d &depth, ContactForces &contact) const
  {
    const ContactLine &line = surface.lines[l];
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();
    bool loaded = false;
    law.integrate(line, depth,
                  [&](const LinePoint &point)
                  {
                    loaded = true;
                    const double local_depth = point.shape.dot(depth);
                    force += law.pressure(local_depth) * point.area * point.shape;
                    tangent +=
                      law.stiffness(local_depth) * point.area * point.shape * point.shape.transpose();
                  });
    for (const std::size_t place : { l, image })
      contact.active_set[place] = loaded;
    if (loaded)
      pattern.add(l, image, force, tangent, contact.forces, contact.tangent);
  }

  const ContactSurface &surface;
  const LinePattern pattern;
  const Pressure law;
};

/// An interface whose pressure depends on the local penetration alone. @p Law derives from
/// PressureInterface<Law> and offers what PressureLaw asks of a pressure, and `validate()`, which throws
/// std::invalid_argument for parameters that are not allowed.
template <typename Law>
class PressureInterface : public InterfaceLaw
{
public:
  std::unique_ptr<TableLaw> make(const ContactSurface &surface, double /*penalty*/) const override
  {
    const Law &law = static_cast<const Law &>(*this);
    law.validate();
    return std::make_unique<PressureLaw<Law>>(surface, law);
  }
};

} // namespace stemware::fem
