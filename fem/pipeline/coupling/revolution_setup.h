#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/revolution/revolution_setup.h"

namespace stemware::pipeline
{

/// The foot of revolution and the table that @p study asks for, resolved for its weight.
fem::RevolutionSetup revolution_setup(const Study &study);

} // namespace stemware::pipeline
