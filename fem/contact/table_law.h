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

/// Active set of the contact surface. Two equal sets mean that the law stayed on the same linear branch.
using ActiveSet = std::vector<bool>;

/// Nodal forces of a table law, their derivative, and the active set. On a distributed surface: for the lines
/// and nodes of this rank (ContactSurface).
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

/// Load on a table: point forces on this part of the surface, and load per radian along the azimuth of the
/// whole surface.
struct TableLoad
{
  SurfaceParts parts; ///< parts of the surface
  /// Point forces that resolve the harmonics: at quadrature points of the pressure, or at the nodes if the
  /// law has only nodal forces.
  std::vector<PointForce> points;
  /// Load per radian at the azimuth of each line, sorted by azimuth; means of sectors if the lines are not
  /// radial.
  std::vector<AzimuthLoad> density;
};

/// Part of the land that is under pressure. A pressure below 1e-11 of the largest is rounding.
struct ContactExtent
{
  /// Share of the land's area. On a crowned land (ContactSurface::is_crowned), whose contact is a band, an
  /// azimuth counts with its whole area if any of its points is under pressure.
  double area_share = 0;
  /// Share of the azimuths with a point under pressure; std::nullopt unless the land is a ring.
  std::optional<double> azimuth_share = {};
  double peak_pressure = 0; ///< [Pa]
};

/// Contact forces as a function of the normal displacement of the contact surface (docs/method.md, "The
/// table").
///
/// `normal_displacement` is relative to the table, u_z + q0 + q1 x + q2 y at the contact nodes [m]. Its sum
/// with the gap is the remaining distance; minus the sum is the penetration. Forces are derivatives of a
/// convex potential: equilibrium minimises an energy, and a damped Newton method converges from any start.
class TableLaw
{
public:
  virtual ~TableLaw() = default;

  /// Evaluates forces, tangent and active set at a normal displacement of shape [n_nodes]. @p contact is
  /// empty or was filled by this law before; its memory is reused.
  virtual void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const = 0;

  /// Returns the load on the table of a solution on this surface. @p n_parts >= 1: number of parts of each
  /// line with quadrature points of their own, for laws that integrate along lines.
  virtual TableLoad load(const ContactSolution &solution, unsigned int n_parts) const = 0;

  /// Returns the extent of the contact of a solution, on the whole surface.
  virtual ContactExtent extent(const ContactSolution &solution) const = 0;

  /// Returns the pressure map of a solution on the whole surface, for plots: on the rank of the first part,
  /// empty elsewhere.
  virtual PressureMap pressure_map(const ContactSolution &solution) const = 0;

  /// Returns the pressure at the contact nodes of a solution [Pa], for plots. Nodes of other parts may lack
  /// it. Shape [n_nodes].
  virtual Eigen::VectorXd nodal_pressure(const ContactSolution &solution) const = 0;

  /// Returns the pressure [Pa] at a penetration [m] for local laws; empty for others.
  virtual std::optional<double> pressure_at(double /*penetration*/) const { return std::nullopt; }

  /// Sets the multipliers of a hard law to the nodal @p forces of a contact nearby. Empty: unknown.
  virtual void set_multipliers(const Eigen::VectorXd & /*forces*/) {}

  /// Updates the multipliers of a hard law after convergence of Newton's method; returns the largest
  /// violation of the contact conditions [m]. Returns 0 for laws without multipliers.
  virtual double augmented_lagrangian_update(const Eigen::VectorXd & /*normal_displacement*/) { return 0; }
};

} // namespace stemware::fem
