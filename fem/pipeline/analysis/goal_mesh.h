#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <optional>

namespace stemware::pipeline
{

/// Discretisation error of one number of a study on the mesh of a solid foot.
struct GoalError
{
  double value = 0;     ///< value of the goal in the study
  fem::MeshError error; ///< correction in the unit of the value: rad/s, 1 or N m
};

/// Estimates the discretisation error of @p goal on the mesh of the solid foot @p foot by finer elements
/// (docs/method/error_bands.md, "The error of one number"):
///
///   terminal spin   error of the torque at that spin over its slope, with the moment balance [rad/s]
///   a2              a_2 / a_0 of the load at rest
///   torque          tau_z at half the terminal spin [N m]
///
/// @p load: find_load() of the foot's study; @p omega_terminal: its terminal spin [rad/s]; @p with_cells:
/// also the cells' shares. May solve a contact. Returns std::nullopt for a body of revolution, without a
/// contact or a balance, for one ring, and for a foot whose load depends on the direction of the moment.
std::optional<GoalError> goal_error(const ElasticFoot &foot, const BalancedLoad &load, double omega_terminal,
                                    Goal goal, bool with_cells = false);

/// Mesh for a goal, and the value of the goal with its estimated remaining error.
struct GoalOutcome
{
  Discretisation discretisation = {};
  double value = 0;           ///< [rad/s, 1 or N m]
  double estimated_error = 0; ///< exact minus computed value
  std::size_t n_meshes = 0;   ///< 0 if the study has no goal
  std::size_t n_cells = 0;    ///< cells of the last mesh
};

/// Returns the mesh of @p study; the default discretisation without a goal. On each mesh, the cells with most
/// of the error are halved. The last mesh meets two conditions: the estimated error of Contact/Goal is within
/// its tolerance, and the sum of the cells' absolute shares in this error is within five tolerances. The
/// progress of @p executor receives the meshes. Throws BadInput for a mesh file whose load depends on the
/// direction of the moment; std::runtime_error if twenty meshes or Contact/Memory limit are not enough, or
/// the estimate fails; and as find_load() and ring::terminal_spin(). Collective if the body is.
GoalOutcome mesh_for_goal(const Study &study, const Executor &executor);

} // namespace stemware::pipeline
