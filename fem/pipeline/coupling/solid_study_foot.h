#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/discretisation.h"
#include "fem/pipeline/study/study.h"

#include <memory>

namespace stemware::pipeline
{

/// Makes the foot of a study with a solid body; only in builds with STEMWARE_SOLID. Collective. Shares mesh
/// and elements with @p similar if both are equal and not used simultaneously. Throws BadInput for an
/// unusable mesh file, std::invalid_argument for an inadmissible setup.
std::shared_ptr<fem::Foot> make_solid_foot(const Study &study, const Discretisation &discretisation,
                                           const Model &model, const fem::Foot *similar);

} // namespace stemware::pipeline
