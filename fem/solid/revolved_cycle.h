#pragma once

#include "fem/solid/revolved_body.h"

namespace stemware::fem
{

/// Two-grid cycle on a mesh too large to be factorised: Chebyshev smoothing before and after a correction by
/// the body of revolution that the mesh is on average. Symmetric.
class RevolvedCycle : public CoarseSolver
{
public:
  /// Keeps a reference to @p matrix, that of @p level, whose contact is set before this one's.
  /// @p nodes: contact nodes of the level.
  RevolvedCycle(const SolidLevel &level, const LevelMatrix &matrix, const ElasticMaterial &material,
                const std::shared_ptr<const ContactNodes> &nodes);

  void set_contact(const Eigen::SparseMatrix<double> &tangent) override;
  void operator()(unsigned int level, FloatVector &dst, const FloatVector &src) const override;

private:
  const LevelMatrix &matrix;
  RevolvedBody body;
  LevelSmoother smoother;
};

} // namespace stemware::fem
