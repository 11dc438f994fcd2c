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

/// The foot that the study asks for, on its table; feet that are to share what they can are given the same
/// @p cache. A solid foot, for which all ranks call this together, shares mesh and elements with @p similar
/// where that has the same and is not asked while this one solves. Throws BadInput as load_modules_of(), and
/// for a mesh file or a setup that cannot be used.
std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     const fem::Foot *similar = nullptr);

/// The section of that foot with its cells, of one rank alone. Throws as make_foot().
std::vector<fem::SectionPolygon> foot_section(const Study &study);

/// True if the meridional mesh of @p study has smaller cells where the contact is expected.
bool has_focused_mesh(const Study &study);

/// True if the foot of @p study feels a hard table by a stiff spring, ContactSection::hardness; a solid foot
/// on a mesh without a hierarchy has nodal multipliers.
bool uses_penalty_for_hard_table(const Study &study);

} // namespace stemware::pipeline
