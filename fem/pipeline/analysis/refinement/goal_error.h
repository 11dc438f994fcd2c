#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"

#include <optional>

namespace stemware::pipeline
{

/// Error of one number of a study that is due to the mesh of the foot.
struct GoalError
{
  double value = 0;     ///< of the study
  fem::MeshError error; ///< its correction in the unit of the value: rad/s, 1 or N m
};

/// The error that the mesh of @p foot has in @p goal, estimated by a dual problem
/// (docs/method/error_bands.md, "The error of one number"):
///
///   terminal spin   the torque's at that spin over its slope, the balance of moments included [rad/s]
///   a2              a_2 / a_0 of the load at rest
///   torque          tau_z at half the terminal spin [N m]
///
/// @p load is find_load() of the study, @p omega_terminal its terminal spin [rad/s]. Nothing where there is
/// no such estimate: without a contact, for an out-of-flat rim or table, a foot whose load depends on where
/// the moment points, elements of degree 4, one ring, or a load that has lost its balance. @p with_cells:
/// with the cells' shares. May solve a contact.
std::optional<GoalError> goal_error(const Study &study, const ElasticFoot &foot, const BalancedLoad &load,
                                    double omega_terminal, Goal goal, bool with_cells = false);

} // namespace stemware::pipeline
