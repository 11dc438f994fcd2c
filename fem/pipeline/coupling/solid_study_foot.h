#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/discretisation.h"
#include "fem/pipeline/study/study.h"

#include <memory>

namespace stemware::pipeline
{

/// Makes the foot of a study with a solid body, in builds with STEMWARE_SOLID. Collective. @p similar as in
/// make_foot(). Throws BadInput for an unusable mesh file, std::invalid_argument for an invalid setup.
std::shared_ptr<fem::Foot> make_solid_foot(const Study &study, const Discretisation &discretisation,
                                           const Model &model, const fem::Foot *similar);

} // namespace stemware::pipeline
