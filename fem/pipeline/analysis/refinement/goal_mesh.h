#pragma once

#include "fem/pipeline/variants/refinement_axis.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>

namespace stemware::pipeline
{

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
/// @p progress is told of the meshes. Throws BadInput for a mesh file whose load depends on where the moment
/// points, std::runtime_error where twenty meshes or Contact/Memory limit are not enough or the estimate
/// cannot be had, and as find_load() and terminal_spin(). Collective where the body is.
MeshForGoal mesh_for_goal(const Study &study, const Executor &executor,
                          Progress &progress = silent_progress());

/// The last three meshes for the goal of @p study, of which its own is the last, and two further ones: what
/// stands in the place of the axis of meshes. Throws as mesh_for_goal().
RefinementAxis goal_axis(const Study &study, const Executor &executor);

} // namespace stemware::pipeline
