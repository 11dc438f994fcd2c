#pragma once

#include "fem/contact/foot.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/revolution/compliance_cache.h"

#include <memory>

namespace stemware::pipeline
{

/// Starts MPI for a study with a solid foot. Throws BadInput in a build without solid feet.
void prepare_foot_of(const Study &study);

/// Makes the foot of a study on its table; feet with the same @p cache share compliances. Collective for a
/// solid foot, which shares mesh and elements with @p similar if these are equal; then only one of the two
/// feet may be used at a time. Throws BadInput as prepare_foot_of(), and for an unusable mesh file or setup.
std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     const fem::Foot *similar = nullptr,
                                     const Discretisation &discretisation = {}, const Model &model = {});

/// Returns make_foot() with @p cache, which must outlive it.
FootMaker foot_maker(fem::ComplianceCache &cache);

/// Returns study_foot() by make_foot() with the shared @p cache.
std::shared_ptr<ElasticFoot> study_foot(const Study &study, fem::ComplianceCache &cache,
                                        Progress &progress = silent_progress(),
                                        const ElasticFoot *similar = nullptr,
                                        const Discretisation &discretisation = {}, const Model &model = {});

/// Returns the meridional section of the study's foot with its cells; not collective. Throws as make_foot().
std::vector<fem::SectionPolygon> foot_section(const Study &study, const Discretisation &discretisation = {});

/// Returns true if the meridional mesh of @p study has smaller cells in the expected contact zone.
bool has_focused_mesh(const Study &study, const Discretisation &discretisation);

/// Returns true if the foot of @p study uses a penalty law for a hard table (Discretisation::hardness), false
/// for the nodal multipliers of a solid foot on a mesh without a hierarchy.
bool uses_penalty_for_hard_table(const Study &study, const Discretisation &discretisation);

} // namespace stemware::pipeline
