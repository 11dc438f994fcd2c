#pragma once

#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/refusal.h"

#include <string>
#include <utility>
#include <vector>

namespace stemware::test
{

/// Returns the default glass on a stiff Winkler mat on a rigid table. This contact is solved fastest.
inline pipeline::Study mat_study()
{
  pipeline::Study study;
  study.table.interface = pipeline::TableInterface::winkler;
  study.table.substrate = pipeline::TableSubstrate::rigid;
  study.table.foundation_modulus = 1e10;
  return study;
}

using EntryTexts = std::vector<std::pair<std::string, std::string>>;

inline pipeline::Study mat_study_with(const EntryTexts &settings)
{
  return pipeline::with_values(mat_study(), "the test", settings);
}

/// Returns the message that refuses mat_study() with @p settings; empty if @p settings are allowed.
inline std::string refusal_of(const EntryTexts &settings)
{
  return sentence_of([&] { mat_study_with(settings); });
}

} // namespace stemware::test
