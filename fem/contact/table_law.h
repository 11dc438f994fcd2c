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

/// Active set of the contact surface: for each node (hard law) or line, whether it is loaded.
using ActiveSet = std::vector<bool>;

/// Nodal forces of a table law, their derivative, and the active set, of this rank's part of the surface.
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

/// Load on a table: point forces on this part of the surface, load per radian of the whole surface.
struct TableLoad
{
  SurfaceParts parts; ///< parts of the surface
  /// Point forces: at quadrature points of the pressure, or at the nodes if a law has nodal forces only.
  std::vector<PointForce> points;
  /// Load per radian by azimuth: of each line, or means of sectors if the lines are not radial.
  std::vector<AzimuthValue> density;
};

/// Part of the land that is under pressure.
struct ContactExtent
{
  static constexpr double rounding_share = 1e-11; ///< smaller pressures, over the largest, are rounding
  /// Share of the land's area; on a crowned land, share of the area of azimuths with a point under pressure.
  double area_share = 0;
  /// Share of the azimuths with a point under pressure; std::nullopt unless the land is a ring.
  std::optional<double> azimuth_share = {};
  double peak_pressure = 0; ///< [Pa]
};

/// Contact forces as a function of the normal displacement of the contact surface (docs/method.md, "The
/// table"). `normal_displacement` is relative to the table, u_z + q0 + q1 x + q2 y at the contact nodes [m].
/// The penetration is minus the sum of this displacement and the gap. Forces are derivatives of a convex
/// potential: equilibrium minimises an energy, and a damped Newton method converges from any start.
class TableLaw
{
public:
  virtual ~TableLaw() = default;

  /// Evaluates the law at @p normal_displacement, [n_nodes]. @p contact: empty or filled by this law before.
  virtual void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const = 0;

  /// Returns the load of @p solution. @p n_parts >= 1: parts of each line with own quadrature points.
  virtual TableLoad load(const ContactSolution &solution, unsigned int n_parts) const = 0;

  /// Returns the extent of the contact of a solution, on the whole surface.
  virtual ContactExtent extent(const ContactSolution &solution) const = 0;

  /// Returns the pressure map of the whole surface, for plots: on the first rank, empty elsewhere.
  virtual PressureMap pressure_map(const ContactSolution &solution) const = 0;

  /// Returns the pressure at the contact nodes [Pa], for plots; possibly not at ghost nodes. Shape [n_nodes].
  virtual Eigen::VectorXd nodal_pressure(const ContactSolution &solution) const = 0;

  /// Returns the pressure [Pa] at a penetration [m] for local laws; empty for others.
  virtual std::optional<double> pressure_at(double /*penetration*/) const { return std::nullopt; }

  /// Sets the multipliers of a hard law to nodal @p forces of a nearby contact; empty: unknown.
  virtual void set_multipliers(const Eigen::VectorXd & /*forces*/) {}

  /// Updates the multipliers of a hard law after Newton's method has converged; returns the largest violation
  /// of the contact conditions [m], 0 without multipliers.
  virtual double augmented_lagrangian_update(const Eigen::VectorXd & /*normal_displacement*/) { return 0; }
};

} // namespace stemware::fem
