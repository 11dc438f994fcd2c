#pragma once

#include "fem/contact/foot.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/study/study.h"

#include <memory>

namespace stemware::fem
{
class ComplianceCache;
}

namespace stemware::pipeline
{

/// Loads the modules that make the foot of @p study, and starts MPI for a solid one. Throws BadInput if a
/// module cannot be loaded.
void load_modules_of(const Study &study);

/// Makes the foot of a study on its table; feet with the same @p cache share compliances. Collective for a
/// solid foot, which shares mesh and elements with @p similar if both are equal and not used simultaneously.
/// Throws BadInput as load_modules_of(), and for an unusable mesh file or setup.
std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     const fem::Foot *similar = nullptr);

/// Returns the meridional section of the study's foot with its cells; not collective. Throws as make_foot().
std::vector<fem::SectionPolygon> foot_section(const Study &study);

/// Returns whether the meridional mesh of @p study has smaller cells in the expected contact zone.
bool has_focused_mesh(const Study &study);

/// Returns whether the foot of @p study uses a penalty law for a hard table (ContactSection::hardness); a
/// solid foot on a mesh without a hierarchy has nodal multipliers.
bool uses_penalty_for_hard_table(const Study &study);

} // namespace stemware::pipeline
