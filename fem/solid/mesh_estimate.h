#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/contact/foot.h"
#include "fem/contact/interface_law.h"
#include "fem/solid/solid_body.h"

namespace stemware::fem
{

/// Solved contact of a solid foot, in the axes of its mesh.
struct SolvedSolidContact
{
  const SolidBody &body; ///< whose displacement is that of the contact
  const InterfaceLaw &interface;
  SolidGap gap;
  SlidingTraction sliding;
  ContactDemand demand = {};
  ContactSolution solution = {};
  ContactLoad load = {}; ///< on the rings of the goal
  double inner_radius = 0;
  double outer_radius = 0;
  bool straight_edges = false; ///< SolidOptions::straight_edges
};

/// Error of @p goal, in the axes of @p contact, that is due to the contact's mesh
/// (docs/method/error_bands.md, "The error of one number").
///
/// The contact is found again from the mesh's own displacement, on elements of one degree more that are
/// halved under the load and at re-entrant edges, friction and conditions included: the correction is what
/// that changes in the goal. The cells' shares are the residual of the mesh's own displacement under the
/// forces found, times what the own elements leave out of the dual displacement, unknown by unknown; the dual
/// system is taken without friction and with resultants in the place of other conditions. Cells are numbered
/// by CellNumbers.
///
/// Multigrid solves both systems (MeshHierarchy), whatever the own system is solved by. Collective. Throws
/// std::invalid_argument where the coarsest mesh is too large for it, std::runtime_error where it does not
/// converge, and ContactFailure.
MeshError estimate_mesh_error(const SolvedSolidContact &contact, const ContactGoal &goal, bool with_cells);

} // namespace stemware::fem
