#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/discretisation.h"
#include "fem/pipeline/study/study.h"

#include <memory>

namespace stemware::pipeline
{

/// Function table stemware_solid_feet of the module solid, which needs deal.II with MPI, p4est and Trilinos.
struct SolidFootFunctions
{
  /// make_foot() of a study with a solid body. Throws BadInput for a mesh file that cannot be used,
  /// std::invalid_argument for a setup that cannot.
  std::shared_ptr<fem::Foot> (*make_foot)(const Study &study, const Discretisation &discretisation,
                                          const Model &model, const fem::Foot *similar);
};

} // namespace stemware::pipeline
