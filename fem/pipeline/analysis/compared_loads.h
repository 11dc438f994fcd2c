#pragma once

#include "fem/pipeline/analysis/yaw_study.h"
#include "fem/pipeline/coupling/foot_contact.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// One load over the spin, of one kind and closure, with some of its harmonics.
struct ComparedLoad
{
  LoadAtSpin at_spin; ///< throws ring::Tipping, fem::ContactFailure, std::runtime_error without a balance
  /// Share of the rim that carries load at a spin, all harmonics kept; empty for a formal load.
  std::function<double(double omega)> contact_fraction;
};

/// A kind of load that a glass may stand on.
struct LoadKind
{
  std::string name;                 ///< "rigid flat rim"
  std::vector<unsigned int> orders; ///< numbers of harmonics to keep, the last one is all
  /// Throws as at_spin, and BadInput for a closure under which the foot tips at rest.
  std::function<ComparedLoad(ring::Closure closure, unsigned int n_harmonics)> load;
};

/// The name of the kind balanced_foot_kind().
inline constexpr char balanced_foot[] = "elastic foot";

/// The paper's load: the first harmonic in balance at every spin, formal where it pulls.
LoadKind first_harmonic_kind(const Study &study);

/// A rigid ring of the contact radius on a foundation that only pushes, lambda ~ max(0, cos - c)^p, in
/// balance at every spin.
LoadKind rigid_ring_kind(const Study &study, double exponent);

/// The elastic foot @p foot of the study with the load of rest at every spin: no friction acts back.
LoadKind resting_foot_kind(const Study &study, const std::shared_ptr<FootContact> &foot);

/// The same foot in balance with friction at every spin.
LoadKind balanced_foot_kind(const Study &study, const std::shared_ptr<FootContact> &foot);

} // namespace stemware::pipeline
