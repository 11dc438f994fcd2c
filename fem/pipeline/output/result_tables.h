#pragma once

#include "fem/pipeline/analysis/study_result.h"

#include <filesystem>

namespace stemware::pipeline
{

/// Writes load.dat, harmonics.dat, torque.dat, spin_up.dat, truncation.dat and, after a contact,
/// contact_history.dat into @p folder. Throws OutputFailure.
void write_result_tables(const StudyResult &result, const std::filesystem::path &folder);

} // namespace stemware::pipeline
