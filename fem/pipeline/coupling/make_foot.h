#pragma once

#include "fem/geometry/section_view.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/revolution/compliance_cache.h"

#include <memory>
#include <vector>

namespace stemware::pipeline
{

/// Starts MPI for a solid body. Throws BadInput in a build without solid feet.
void prepare_body(BodyKind body);

/// Returns a maker of feet that share compliances in @p cache, which must outlive it. Collective for a solid
/// foot, which shares mesh and elements with a similar foot if these are equal; then only one of the two feet
/// may be used at a time. The maker throws BadInput as prepare_body(), and for an unusable mesh file or
/// setup.
FootMaker foot_maker(fem::ComplianceCache &cache);

/// Makes the foot of a study with a solid body, in builds with STEMWARE_SOLID. Collective. @p similar as in
/// FootMaker. Throws BadInput for an unusable mesh file, std::invalid_argument for an invalid setup.
std::shared_ptr<fem::Foot> make_solid_foot(const FootSpecification &specification, const fem::Foot *similar);

/// Returns the meridional section of a foot with its cells; not collective. Throws as foot_maker().
std::vector<fem::SectionPolygon> foot_section(const FootSpecification &specification);

} // namespace stemware::pipeline
