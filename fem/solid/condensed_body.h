#pragma once

#include "fem/contact/compliant_body.h"
#include "fem/geometry/elastic_material.h"
#include "fem/solid/contact_nodes.h"
#include "fem/solid/solid_level.h"

#include <memory>

namespace stemware::fem
{

/// Compliance of a solid foot on one rank: vertical displacement of the row's contact node per unit force at
/// the column's [m/N], shape [n_nodes, n_nodes].
struct NodalCompliance
{
  Eigen::MatrixXd normal;           ///< compliance for vertical forces; symmetric
  Eigen::MatrixXd along_x, along_y; ///< compliances for horizontal forces; empty unless requested
};

/// Returns the compliance of @p level between its contact @p nodes by static condensation, @p with_horizontal
/// for horizontal forces too. Throws std::runtime_error unless the stiffness is positive definite.
NodalCompliance condense(const SolidLevel &level, const ElasticMaterial &material, const ContactNodes &nodes,
                         bool with_horizontal);

/// Solid foot condensed to its contact nodes: a Newton step is a dense system of the loaded nodes.
class CondensedBody : public CompliantBody
{
public:
  /// @p surface of one rank, which must outlive the body.
  CondensedBody(const ContactSurface &surface, std::shared_ptr<const NodalCompliance> compliance);

  /// Sets the friction force (x, y) on the foot per normal force, shape [n_nodes, 2]; empty: no friction.
  void set_friction(const Eigen::MatrixX2d &friction);

  const ContactSurface &contact_surface() const override { return surface; }
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;

private:
  const Eigen::MatrixXd &matrix() const
  {
    return with_friction.size() > 0 ? with_friction : compliance->normal;
  }
  Eigen::VectorXd response_to(const Eigen::VectorXd &forces) const override { return matrix() * forces; }

  const ContactSurface &surface;
  const std::shared_ptr<const NodalCompliance> compliance;
  Eigen::MatrixXd with_friction; ///< compliance of normal forces with their friction; empty without friction
};

} // namespace stemware::fem
