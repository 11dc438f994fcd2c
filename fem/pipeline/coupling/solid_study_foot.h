#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/foot_specification.h"

#include <memory>

namespace stemware::pipeline
{

/// Makes the foot of a study with a solid body, in builds with STEMWARE_SOLID. Collective. @p similar as in
/// FootMaker. Throws BadInput for an unusable mesh file, std::invalid_argument for an invalid setup.
std::shared_ptr<fem::Foot> make_solid_foot(const FootSpecification &specification, const fem::Foot *similar);

} // namespace stemware::pipeline
