#pragma once

#include "fem/pipeline/analysis/closure_comparison.h"
#include "fem/pipeline/analysis/phase_study.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/yaw_study.h"
#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/coupling/ring_load.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The finite-element side of a study.
struct ContactFigures
{
  std::string body;                    ///< FootContact::name()
  std::string friction_coupling;       ///< "elastic" where friction deforms the foot, else "none"
  std::optional<unsigned int> n_cells; ///< of a three-dimensional mesh
  unsigned int n_unknowns = 0;
  unsigned int n_contact_nodes = 0;
  std::optional<fem::MeshReport> mesh_report; ///< of a mesh file
  FootContactResult result;
  fem::Footprint footprint;                   ///< at rest
  fem::ResolvedFriction friction_at_rest;     ///< of the pressure where it lies, beside the ring's
  fem::ResolvedFriction friction_at_terminal; ///< the same at the ring's terminal spin
};

/// Everything that a run finds out.
struct StudyResult
{
  RingLoad load;
  std::optional<ContactFigures> contact; ///< nothing where the load does not come from a contact
  YawStudy yaw;
  TorqueCurve torque;
  SpinUpCurves spin_up;
  std::vector<ClosureRow> closures;
  std::optional<PhaseFigures> phases = {};    ///< nothing where rim and table are flat
  std::vector<BandedFigure> error_bands = {}; ///< of the discretisation; empty: not estimated
};

} // namespace stemware::pipeline
