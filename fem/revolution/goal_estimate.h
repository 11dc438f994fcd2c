#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/contact/foot.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_setup.h"

#include <optional>

namespace stemware::fem
{

/// A contact of a body of revolution that has been solved, and what it was solved with. Rim and table are
/// flat, so that azimuths count from the direction of travel.
struct SolvedContact
{
  const RevolutionSetup &setup;
  const BodyOfRevolution &body; ///< whose contact circles the state's displacement stands on
  const InterfaceLaw &interface;
  BodyOfRevolution::Gap gap = {};
  const ContactState *state = nullptr;
  ComplianceCache *cache = nullptr; ///< of the finer elements
  std::optional<SlidingTraction> sliding = {};
};

/// Error of @p goal that is due to the meridional meshes of @p contact, by the dual-weighted residual
/// (docs/method/error_bands.md, "The error of one number").
///
/// The body is solved once more on elements of one degree more, halved under the load and thrice at
/// re-entrant corners. Its displacement under the forces that the law gives at the mesh's own displacement
/// differs from that displacement by d; the dual of one Newton step there, gap_gradient(), weighs d at every
/// node. The sum is what that step would change, exact but for terms of second order in d. The shares of
/// cells are energy products of what the next lower degree leaves out of the displacement and of the dual
/// one.
///
/// The number of azimuth lines, the harmonics and the integration of the law are not the mesh's. Throws
/// std::invalid_argument for elements of degree 4, above which there are none, and as gap_gradient().
MeshError estimate_mesh_error(const SolvedContact &contact, const ContactGoal &goal, bool with_cells);

} // namespace stemware::fem
