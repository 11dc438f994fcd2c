#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>

namespace stemware::pipeline
{

/// Error of one number of a study that is due to the mesh of a solid foot.
struct GoalError
{
  double value = 0;     ///< of the study
  fem::MeshError error; ///< its correction in the unit of the value: rad/s, 1 or N m
};

/// The error that the mesh of @p foot, a solid one, has in @p goal, estimated on finer elements
/// (docs/method/error_bands.md, "The error of one number"):
///
///   terminal spin   the torque's at that spin over its slope, the balance of moments included [rad/s]
///   a2              a_2 / a_0 of the load at rest
///   torque          tau_z at half the terminal spin [N m]
///
/// @p load is find_load() of the study, @p omega_terminal its terminal spin [rad/s]. Nothing if there is
/// no such estimate: for a body of revolution, without a contact, a foot whose load depends on where the
/// moment points, one ring, or a load that has lost its balance. @p with_cells: with the cells' shares. May
/// solve a contact.
std::optional<GoalError> goal_error(const Study &study, const ElasticFoot &foot, const BalancedLoad &load,
                                    double omega_terminal, Goal goal, bool with_cells = false);

/// Number that a mesh was made for, with the error that the mesh leaves of it.
struct GoalOutcome
{
  double value = 0;           ///< of the number: rad/s, 1 or N m
  double estimated_error = 0; ///< what the mesh takes from it, as estimated: added, it corrects the value
  std::size_t n_meshes = 0;
  std::size_t n_cells = 0; ///< of the last one
};

/// A study on the mesh for its goal.
struct MeshForGoal
{
  Study study;
  std::optional<GoalOutcome> outcome; ///< nothing where the study has no goal
};

/// @p study with cells halved until the estimated error of its goal (Contact/Goal) is no more than
/// its tolerance: mesh after mesh, those cells that have most of the error, as goal_error() shares it out.
/// The cells' shares, of which parts may cancel, may not exceed five tolerances either. The study itself
/// where it has no goal.
///
/// @p progress receives the meshes. Throws BadInput for a mesh file whose load depends on where the moment
/// points, std::runtime_error where twenty meshes or Contact/Memory limit are not enough or the estimate
/// cannot be had, and as find_load() and terminal_spin(). Collective where the body is.
MeshForGoal mesh_for_goal(const Study &study, const Executor &executor,
                          Progress &progress = silent_progress());

} // namespace stemware::pipeline
