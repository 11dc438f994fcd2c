#pragma once

#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Refuses a study whose rim or table is out of flat for @p verb, which follows one load over the spin: that
/// of such a study depends on the yaw angle too. Throws BadInput.
void require_flat(const Study &study, const std::string &verb);

} // namespace stemware::pipeline
