#pragma once

#include "fem/contact/interface_law.h"
#include "fem/contact/line_integral.h"
#include "fem/contact/line_pattern.h"
#include "fem/contact/table_law.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Returns the extent of a contact from the penetrations @p depths [m] at the samples of each line of @p
/// surface, and the local law @p pressure(penetration [m]) [Pa].
ContactExtent extent_of_lines(const ContactSurface &surface, const std::vector<Eigen::Vector3d> &depths,
                              const InterfaceLaw &law, const std::function<double(double)> &pressure);

/// Table whose pressure depends on the local penetration only, integrated along the contact lines. @p
/// Pressure has, for a penetration d [m], non-decreasing `pressure(d)` [Pa]; `pressure_and_stiffness(d)`, the
/// pair of p [Pa] and dp/dd [Pa/m];
/// `has_edge()` as InterfaceLaw; `integrate(area, depth, visit)`, which calls visit(const LinePoint &) at the
/// loaded quadrature points of a line with this area element and penetration at the samples;
/// `cutoff_depth(deepest)`, below which the load is negligible if `deepest` is the largest penetration [m].
template <typename Pressure>
class PressureLaw : public TableLaw
{
public:
  /// Keeps a reference to @p surface.
  PressureLaw(const ContactSurface &surface, const Pressure &pressure)
      : surface(surface)
      , law(pressure)
      , pattern(surface)
      , areas(surface.lines.begin(), surface.lines.end())
  {
  }

  void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const override
  {
    contact.forces.setZero(surface.n_nodes());
    pattern.set_zero(contact.tangent);
    contact.active_set.assign(surface.lines.size(), false);
    const std::vector<Eigen::Vector3d> depths = penetrations(normal_displacement);
    const double least = cutoff_depth(depths);
    for (std::size_t l = 0; l < surface.lines.size(); ++l)
    {
      if (greatest(depths[l]) < least)
        continue;
      const std::size_t image = mirror_image(l, normal_displacement);
      if (image >= l) // otherwise the pair has been added with its other line
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
    const double least = cutoff_depth(depths);
    for (std::size_t l = 0; l < surface.lines.size(); ++l)
    {
      double line_force = 0;
      const auto add = [&](const ContactLine &line, const AreaElement &area, const Eigen::Vector3d &depth)
      {
        if (greatest(depth) < least)
          return;
        const Eigen::Vector3d along = quadratic_through(depth), x = quadratic_through(line.position.col(0)),
                              y = quadratic_through(line.position.col(1));
        law.integrate(area, depth,
                      [&](const LinePoint &point)
                      {
                        const double force = law.pressure(value_at(along, point.xi)) * point.area;
                        result.points.push_back({ value_at(x, point.xi), value_at(y, point.xi), force });
                        line_force += force;
                      });
      };
      if (n_parts == 1)
        add(surface.lines[l], areas[l], depths[l]);
      for (unsigned int i = 0; n_parts > 1 && i < n_parts; ++i)
      {
        const auto [part, depth] =
          part_of(surface.lines[l], depths[l], { 2. * i / n_parts - 1, 2. * (i + 1) / n_parts - 1 });
        add(part, AreaElement(part), depth);
      }
      line_forces.push_back(line_force);
    }
    for (Eigen::Index i = 0; i < solution.force_mismatch.size(); ++i)
      if (const double force = solution.force_mismatch(i); force != 0)
        result.points.push_back({ surface.node_position(i, 0), surface.node_position(i, 1), force });
    result.density = density_of_lines(surface, line_forces);
    return result;
  }

  ContactExtent extent(const ContactSolution &solution) const override
  {
    return extent_of_lines(surface, penetrations(solution.normal_displacement), law,
                           [this](double depth) { return law.pressure(depth); });
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

protected:
  std::vector<Eigen::Vector3d> penetrations(const Eigen::VectorXd &normal_displacement) const
  {
    std::vector<Eigen::Vector3d> depths;
    depths.reserve(surface.lines.size());
    for (const ContactLine &line : surface.lines)
      depths.push_back(penetration(line, normal_displacement));
    return depths;
  }

  const ContactSurface &surface;
  const Pressure law;

private:
  /// Returns an upper bound of the penetration on a line, by its Bezier control points.
  static double greatest(const Eigen::Vector3d &depth)
  {
    return std::max({ depth(0), depth(2), 2 * depth(1) - (depth(0) + depth(2)) / 2 });
  }

  double cutoff_depth(const std::vector<Eigen::Vector3d> &depths) const
  {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d &depth : depths)
      deepest = std::max(deepest, depth.maxCoeff());
    return law.cutoff_depth(surface.parts.max(deepest));
  }

  /// Returns the mirror image of line @p l if gap and displacement are equal to the last bit, else @p l.
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

  /// Adds the forces and the tangent of line @p l under @p depth as LinePattern::add().
  void add_line(std::size_t l, std::size_t image, const Eigen::Vector3d &depth, ContactForces &contact) const
  {
    const Eigen::Vector3d along = quadratic_through(depth);
    double pressures[3] = {}, stiffnesses[5] = {}; // moments in the local coordinate
    bool loaded = false;
    law.integrate(areas[l], depth,
                  [&](const LinePoint &point)
                  {
                    loaded = true;
                    const auto [pressure, stiffness] = law.pressure_and_stiffness(value_at(along, point.xi));
                    const double xi = point.xi, xi_2 = xi * xi, force = pressure * point.area,
                                 tangent = stiffness * point.area;
                    pressures[0] += force;
                    pressures[1] += force * xi;
                    pressures[2] += force * xi_2;
                    stiffnesses[0] += tangent;
                    stiffnesses[1] += tangent * xi;
                    stiffnesses[2] += tangent * xi_2;
                    stiffnesses[3] += tangent * xi_2 * xi;
                    stiffnesses[4] += tangent * xi_2 * xi_2;
                  });
    for (const std::size_t place : { l, image })
      contact.active_set[place] = loaded;
    if (!loaded)
      return;
    // The shape functions (xi^2 - xi)/2, 1 - xi^2, (xi^2 + xi)/2 and their products, by their moments.
    const Eigen::Vector3d force((pressures[2] - pressures[1]) / 2, pressures[0] - pressures[2],
                                (pressures[2] + pressures[1]) / 2);
    const auto &[k0, k1, k2, k3, k4] = stiffnesses;
    const double to_left = (k2 - k1 - k4 + k3) / 2, to_right = (k2 + k1 - k4 - k3) / 2,
                 across = (k4 - k2) / 4;
    Eigen::Matrix3d tangent;
    tangent << (k4 - 2 * k3 + k2) / 4, to_left, across, //
      to_left, k0 - 2 * k2 + k4, to_right,              //
      across, to_right, (k4 + 2 * k3 + k2) / 4;
    pattern.add(l, image, force, tangent, contact.forces, contact.tangent);
  }

  const LinePattern pattern;
  const std::vector<AreaElement> areas; ///< area elements of the lines
};

/// Interface whose pressure depends on the local penetration only. @p Law derives from PressureInterface<Law>
/// and has the members of PressureLaw's `Pressure`, and `validate()`, which throws std::invalid_argument.
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
