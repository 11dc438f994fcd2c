#pragma once

#include "fem/contact/azimuthal_density.h"
#include "fem/contact/contact_surface.h"
#include "fem/contact/pressure_map.h"

#include <Eigen/SparseCore>

#include <memory>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// Which places of the contact surface carry load; two equal sets mean that the law has stayed on the same
/// linear branch.
using ContactSet = std::vector<bool>;

/// Nodal forces of a table law, and how they change.
struct LawResponse
{
  Eigen::VectorXd forces; ///< consistent upward forces on the foot at the contact nodes [N]
  Eigen::SparseMatrix<double>
    tangent; ///< d forces / d penetration, symmetric positive semidefinite [N/m], [n_nodes, n_nodes]
  ContactSet contact_set;

  /// Exchanges the contents without copying the tangent.
  void swap(LawResponse &other)
  {
    forces.swap(other.forces);
    tangent.swap(other.tangent);
    contact_set.swap(other.contact_set);
  }
};

/// What a table carries, point by point and along the azimuth.
struct TableLoad
{
  /// Fine enough for harmonics: quadrature points of the pressure, or nodal forces where there is no
  /// pressure.
  std::vector<PointForce> points;
  /// Load per radian at the azimuth of each line, sorted by azimuth; sectors' means where the lines are not
  /// radial.
  std::vector<AzimuthLoad> density;
};

/// How the table answers a given approach of the contact surface (docs/method.md, "The table").
///
/// `approach` is u_z + q0 + q1 x + q2 y at the contact nodes [m]; gap + approach is the distance left, -(gap
/// + approach) the penetration. Forces are derivatives of a convex potential, so that equilibrium minimises
/// an energy and a damped Newton method finds it from anywhere.
class TableLaw
{
public:
  virtual ~TableLaw() = default;

  /// Forces, tangent and contact set at an approach of shape [n_nodes]. @p response is empty or was filled by
  /// this law before: its memory is used again.
  virtual void respond(const Eigen::VectorXd &approach, LawResponse &response) const = 0;

  /// The same load, forgetting the nodes.
  virtual TableLoad load(const Eigen::VectorXd &approach) const = 0;

  /// Only the points of load().
  std::vector<PointForce> point_forces(const Eigen::VectorXd &approach) const
  {
    return load(approach).points;
  }

  /// Where the foot presses, for pictures.
  virtual Footprint footprint(const Eigen::VectorXd &approach) const = 0;

  /// Nodal pressure [Pa] for pictures.
  virtual Eigen::VectorXd nodal_pressure(const Eigen::VectorXd &approach) const = 0;

  /// Pressure [Pa] at a penetration [m], for laws by which it depends on that alone; nothing for the others.
  virtual std::optional<double> pressure_at(double /*penetration*/) const { return std::nullopt; }

  /// Tells a law with multipliers (rigid table) that Newton's method has converged; returns the largest
  /// violation of the contact conditions that it has left [m]. Laws without multipliers have none: 0.
  virtual double update_multipliers(const Eigen::VectorXd & /*approach*/) { return 0; }
};

/// Thin elastic mat (Winkler foundation): pressure = modulus * penetration where positive, integrated along
/// each contact line in closed form, split at the roots of the penetration. @p modulus in Pa/m. Throws
/// std::invalid_argument unless the modulus is positive and finite.
std::unique_ptr<TableLaw> make_mat(const ContactSurface &surface, double modulus);

/// Rigid table: f_i >= 0, gap_i >= 0, f_i gap_i = 0 at the contact nodes, by an augmented Lagrangian whose
/// multipliers are the nodal forces.
/// @p penalty [Pa/m] only steers the path to the solution; E / (cell size) is the natural scale.
std::unique_ptr<TableLaw> make_rigid_table(const ContactSurface &surface, double penalty);

/// Asperities of a nominally flat rough surface on a smooth one: pressure = reference_pressure *
/// exp(-separation / decay_length), the separation being that of the mean planes.
///
/// Greenwood & Williamson, Proc. R. Soc. A 295 (1966) 300, for exponentially distributed summits; Persson,
/// Phys. Rev. Lett. 99 (2007) 125502, for self-affine surfaces at low pressure. A factor in the reference
/// pressure is an offset of the table, so the load depends on the decay length alone as long as the mean
/// planes do not meet; beyond, the law goes on as its tangent.
struct RoughInterface
{
  double reference_pressure = 1e9; ///< at touching mean planes [Pa]
  double decay_length = 1e-6;      ///< [m], of the order of the rms roughness
};

/// Throws std::invalid_argument unless both figures of @p interface are positive and finite.
std::unique_ptr<TableLaw> make_rough_interface(const ContactSurface &surface,
                                               const RoughInterface &interface);

} // namespace stemware::fem
