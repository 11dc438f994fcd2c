#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/study/study.h"

#include <memory>

namespace stemware::pipeline
{

/// Whether this program makes solid feet. Their deal.II has MPI, p4est and Trilinos: an executable is linked
/// with solid_feet.cc where it is so, else with without_solid_feet.cc.
bool has_solid_feet();

/// make_foot() of a study with a solid body, where has_solid_feet(). Throws BadInput for a mesh file that
/// cannot be used, std::invalid_argument for a setup that cannot.
std::shared_ptr<fem::Foot> make_solid_foot(const Study &study, const fem::Foot *similar);

} // namespace stemware::pipeline
