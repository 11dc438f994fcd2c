#include "fem/solid/revolved_cycle.h"

namespace stemware::fem
{

RevolvedCycle::RevolvedCycle(const SolidLevel &level, const LevelMatrix &matrix,
                             const ElasticMaterial &material,
                             const std::shared_ptr<const ContactNodes> &nodes)
    : matrix(matrix)
    , body(level, material, nodes)
{
  smoother.initialize(matrix, smoothing_of(matrix));
  FloatVector vector;
  matrix.initialize_dof_vector(vector);
  smoother.estimate_eigenvalues(vector);
}

void RevolvedCycle::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  body.set_contact(tangent);
}

void RevolvedCycle::operator()(unsigned int, FloatVector &dst, const FloatVector &src) const
{
  smoother.vmult(dst, src);
  FloatVector residual;
  matrix.initialize_dof_vector(residual);
  matrix.vmult(residual, dst);
  residual.sadd(-1, 1, src);
  body.add_correction(dst, residual);
  smoother.step(dst, src);
}

} // namespace stemware::fem
