#pragma once

#include "fem/pipeline/analysis/spin_row.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Error of the terminal spin that follows from the scatter of a drawn profile's points.
struct ProfileScatter
{
  std::optional<double> spin = {}; ///< standard error of the terminal spin [rad/s]
  std::optional<double>
    by_contact_radius = {};                   ///< d omega / d R [rad/(s m)]; nothing for an R that was given
  std::optional<double> by_crown_radius = {}; ///< d omega / d (crown radius) [rad/(s m)]; likewise
  std::string reason = {};                    ///< why there is no spin; empty where there is one
};

/// Follows the standard errors of contact and crown radius (GlassSection::rim_circle) to the terminal spin:
/// sigma^2 = g^T C g, g from the study solved again with a rim that is one standard error larger and smaller.
/// The crown is changed in its curvature, by half of it at most, so that g is finite where the points leave
/// the crown open. A solid foot is followed on the body of revolution. @p all is the answer of @p study.
/// Nothing where no value of the rim has a scatter, or the glass does not spin. Does not throw for a study
/// that fails.
std::optional<ProfileScatter> profile_scatter(const Study &study, const SpinRow &all,
                                              const Executor &executor,
                                              Progress &progress = silent_progress());

} // namespace stemware::pipeline
