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
  const SolidBody &body; ///< body in the state of the contact
  const InterfaceLaw &interface;
  SolidGap gap;
  SlidingTraction sliding;
  ContactState state;          ///< its load is on the rings of the goal
  bool straight_edges = false; ///< SolidOptions::straight_edges
};

/// Returns the discretisation error of @p goal, in the axes of @p contact (docs/method/error_bands.md, "The
/// error of one number").
///
/// The contact is solved again from the present displacement, on elements of one degree more, halved under
/// the load and at re-entrant edges: the correction is the change of the goal. The cells' shares, numbered by
/// CellNumbers, are the residual of the present displacement under the new forces times the dual displacement
/// minus its interpolant; the dual system is without friction, with prescribed resultants. Both systems are
/// solved by multigrid (MeshHierarchy). Collective. Throws std::invalid_argument if the coarsest mesh is too
/// large for multigrid, std::runtime_error without convergence, and ContactFailure.
MeshError estimate_mesh_error(const SolvedSolidContact &contact, const ContactGoal &goal, bool with_cells);

} // namespace stemware::fem
