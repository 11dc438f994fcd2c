#include "fem/solid/condensed_body.h"

#include "fem/contact/contact_solution.h"
#include "fem/revolution/block_inverse.h"
#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/stiffness_3d.h"

#include <Eigen/LU>

#include <utility>
#include <vector>

namespace stemware::fem
{

namespace
{

LowerTriangle lower_triangle_of(const dealii::TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (auto entry = matrix.begin(); entry != matrix.end(); ++entry)
    if (entry->row() >= entry->column())
      entries.emplace_back(static_cast<int>(entry->row()), static_cast<int>(entry->column()), entry->value());
  LowerTriangle lower(static_cast<Eigen::Index>(matrix.m()), static_cast<Eigen::Index>(matrix.m()));
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

std::vector<Eigen::Index> nodes_with_tangent(const Eigen::SparseMatrix<double> &tangent)
{
  std::vector<Eigen::Index> nodes;
  for (Eigen::Index node = 0; node < tangent.cols(); ++node)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, node); entry; ++entry)
      if (entry.value() != 0)
      {
        nodes.push_back(node);
        break;
      }
  return nodes;
}

} // namespace

NodalCompliance condense(const SolidLevel &level, const ElasticMaterial &material, const ContactNodes &nodes,
                         bool with_horizontal)
{
  dealii::TrilinosWrappers::SparseMatrix stiffness;
  assemble_stiffness(level.mapping, level.dof_handler, material, level.constraints, stiffness);
  const LowerTriangle lower = lower_triangle_of(stiffness);
  const auto n = static_cast<Eigen::Index>(nodes.n_nodes());
  std::vector<unsigned int> kept(nodes.dofs().begin(), nodes.dofs().end());
  if (with_horizontal)
  {
    kept.resize(static_cast<std::size_t>(3 * n));
    for (const HorizontalPlaces &places : horizontal_places(level, nodes))
    {
      kept[static_cast<std::size_t>(n) + places.node] = places.x;
      kept[static_cast<std::size_t>(2 * n) + places.node] = places.y;
    }
  }
  const Eigen::MatrixXd columns = BlockInverse(lower, kept)(
    Eigen::Map<const Eigen::VectorXd>(lower.valuePtr(), lower.nonZeros()), nodes.n_nodes());
  NodalCompliance compliance = { columns.topRows(n), {}, {} };
  if (with_horizontal)
  {
    compliance.along_x = columns.middleRows(n, n).transpose();
    compliance.along_y = columns.bottomRows(n).transpose();
  }
  return compliance;
}

CondensedBody::CondensedBody(const ContactSurface &surface, std::shared_ptr<const NodalCompliance> compliance)
    : surface(surface)
    , compliance(std::move(compliance))
{
  reset();
}

void CondensedBody::set_friction(const Eigen::MatrixX2d &friction)
{
  if (friction.size() > 0)
    with_friction = compliance->normal + compliance->along_x * friction.col(0).asDiagonal() +
                    compliance->along_y * friction.col(1).asDiagonal();
  else
    with_friction.resize(0, 0);
  set_forces(state);
}

NewtonIncrement CondensedBody::solve(const Eigen::SparseMatrix<double> &tangent,
                                     const Eigen::VectorXd &forces, const LinearConditions &conditions,
                                     const Eigen::Vector3d &motion)
{
  // ds + T (C ds + Q dq) = f - s, L'(s + ds) + H (q + dq) = t, with nodal forces s, forces f of the table
  // law, table motions q, compliance C, tangent T, modes Q of the table motions, weights L and targets t of
  // the conditions, and motion weights H. Nodes with zero tangent have ds = f - s.
  const std::vector<Eigen::Index> loaded = nodes_with_tangent(tangent);
  const Eigen::VectorXd unbalanced = forces - state;
  Eigen::VectorXd increment = unbalanced;
  increment(loaded).setZero();
  const Eigen::MatrixX3d modes = surface.motion_modes();
  const Eigen::MatrixXd tangent_modes = tangent * modes, of_rest = tangent * (matrix() * increment);
  Eigen::MatrixXd system = (tangent * matrix()(Eigen::all, loaded))(loaded, Eigen::all);
  system.diagonal().array() += 1;
  // Right-hand sides: T Q, and f - s - T C ds, where ds is the increment at the nodes with zero tangent.
  Eigen::MatrixXd solved(system.rows(), 4);
  solved << tangent_modes(loaded, Eigen::all), unbalanced(loaded) - of_rest(loaded, 0);
  solved = system.partialPivLu().solve(solved).eval();

  const Eigen::MatrixX3d weights = conditions.weights()(loaded, Eigen::all);
  const Eigen::Matrix3d resistance = weights.transpose() * solved.leftCols<3>();
  const Eigen::Matrix3d net_resistance = resistance - conditions.motion_weights();
  increment(loaded) = solved.col(3);
  const Eigen::Vector3d residual = conditions.residual(state + increment, motion);
  // The scaling turns tilts into heights at the rim, and moments into forces at the rim.
  const double radius = modes.rightCols<2>().rowwise().norm().maxCoeff();
  const Eigen::DiagonalMatrix<double, 3> scale(1, 1 / radius, 1 / radius);
  const Eigen::Matrix3d scaled = scale * net_resistance * scale;
  const Eigen::Vector3d motion_step = scale * scaled.partialPivLu().solve(scale * residual).eval();
  increment(loaded) -= solved.leftCols<3>() * motion_step;
  if (!increment.allFinite() || !motion_step.allFinite())
    throw ContactFailure(ContactOutcome::linear_solver_failed,
                         "the contact system is singular: the loaded points do not support the foot.");
  return step_by(std::move(increment), motion_step, resistance, conditions);
}

} // namespace stemware::fem
