#pragma once

#include "fem/contact/elastic_body.h"

namespace stemware::fem
{

/// Returns L'TQ, the derivative of the conditions L'f by the motions of a table with @p tangent T under a
/// rigid foot; of a distributed surface this part's contribution. @p weights: L. @p modes: Q,
/// ContactSurface::motion_modes().
Eigen::Matrix3d motion_stiffness(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixX3d &weights,
                                 const Eigen::MatrixX3d &modes);

/// Rigid foot on a moving table: initial guess of cold elastic solves.
class RigidFoot : public ElasticBody
{
public:
  /// Keeps a reference to @p surface.
  explicit RigidFoot(const ContactSurface &surface)
      : surface(surface)
      , modes(surface.motion_modes())
  {
  }

  const ContactSurface &contact_surface() const override { return surface; }
  Eigen::VectorXd contact_displacement() const override { return Eigen::VectorXd::Zero(surface.n_nodes()); }
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;
  void update(double) override {}
  void reset() override {}
  double equilibrium_residual(const Eigen::VectorXd &) const override { return 0; }

private:
  const ContactSurface &surface;
  const Eigen::MatrixX3d modes;
};

} // namespace stemware::fem
