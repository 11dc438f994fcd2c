#pragma once

#include "fem/contact/azimuthal_density.h"
#include "fem/contact/contact_solution.h"
#include "fem/contact/contact_surface.h"
#include "fem/contact/pressure_map.h"

#include <Eigen/SparseCore>

#include <optional>
#include <vector>

namespace stemware::fem
{

/// Which places of the contact surface carry load; two equal sets mean that the law has stayed on the same
/// linear branch.
using ActiveSet = std::vector<bool>;

/// Nodal forces of a table law, their derivative, and the active set: those of the lines and nodes of a part
/// of the surface, where it is in parts (ContactSurface).
struct ContactForces
{
  Eigen::VectorXd forces; ///< consistent upward forces on the foot at the contact nodes [N]
  /// d forces / d penetration, symmetric positive semidefinite [N/m], shape [n_nodes, n_nodes].
  Eigen::SparseMatrix<double> tangent;
  ActiveSet active_set;

  /// Exchanges the contents without copying the tangent.
  void swap(ContactForces &other)
  {
    forces.swap(other.forces);
    tangent.swap(other.tangent);
    active_set.swap(other.active_set);
  }
};

/// Load on a table, point by point on a part of the surface and along the azimuth of the whole.
struct TableLoad
{
  SurfaceParts parts; ///< of the surface
  /// Fine enough for harmonics: quadrature points of the pressure, and what the body's forces have beyond it
  /// at the nodes; or nodal forces where there is no pressure.
  std::vector<PointForce> points;
  /// Load per radian at the azimuth of each line, sorted by azimuth; sectors' means where the lines are not
  /// radial.
  std::vector<AzimuthLoad> density;
};

/// Part of the land that is under pressure. A pressure below 1e-11 of the largest is rounding.
struct ContactExtent
{
  /// Share of the land's area. A crowned land (ContactSurface::is_crowned) touches along a band; an azimuth
  /// of it counts with its whole area if any point of the azimuth is under pressure.
  double area_share = 0;
  /// Share of the azimuths with a point under pressure; std::nullopt unless the land is a ring.
  std::optional<double> azimuth_share = {};
  double peak_pressure = 0; ///< [Pa]
};

/// Contact forces as a function of the normal displacement of the contact surface (docs/method.md, "The
/// table").
///
/// `normal_displacement` is that relative to the table, u_z + q0 + q1 x + q2 y at the contact nodes [m]; its
/// sum with the gap is the distance left, minus that sum the penetration. Forces are derivatives of a convex
/// potential, so that equilibrium minimises an energy and a damped Newton method finds it from anywhere.
class TableLaw
{
public:
  virtual ~TableLaw() = default;

  /// Forces, tangent and active set at a normal displacement of shape [n_nodes]. @p contact is empty or was
  /// filled by this law before: its memory is used again.
  virtual void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const = 0;

  /// Load on the table in any solution on this surface: forces and normal displacement decide it. @p n_parts
  /// >= 1: parts of a line, each with quadrature points of its own, where the law has such.
  virtual TableLoad load(const ContactSolution &solution, unsigned int n_parts) const = 0;

  /// Extent of the contact in a solution, on the whole surface.
  virtual ContactExtent extent(const ContactSolution &solution) const = 0;

  /// Where the foot presses in a solution, for plots: on the whole surface, on the rank of the first part;
  /// empty elsewhere.
  virtual PressureMap pressure_map(const ContactSolution &solution) const = 0;

  /// Pressure at the contact nodes in a solution [Pa], for plots; at those of other parts it need not be
  /// known. Shape [n_nodes].
  virtual Eigen::VectorXd nodal_pressure(const ContactSolution &solution) const = 0;

  /// Pressure [Pa] at a penetration [m], for laws by which it depends on that alone; nothing for the others.
  virtual std::optional<double> pressure_at(double /*penetration*/) const { return std::nullopt; }

  /// Tells a law with multipliers (rigid table) the nodal @p forces of a contact nearby; empty: none is
  /// known.
  virtual void start_from(const Eigen::VectorXd & /*forces*/) {}

  /// Tells a law with multipliers that Newton's method has converged; returns the largest
  /// violation of the contact conditions that it has left [m]. Laws without multipliers have none: 0.
  virtual double augmented_lagrangian_update(const Eigen::VectorXd & /*normal_displacement*/) { return 0; }
};

} // namespace stemware::fem
