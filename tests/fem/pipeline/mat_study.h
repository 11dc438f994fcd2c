#pragma once

#include "fem/pipeline/study/study.h"

namespace stemware::test
{

/// Returns the default glass on a stiff Winkler mat on a rigid table, the fastest contact.
inline pipeline::Study mat_study()
{
  pipeline::Study study;
  study.table.interface = pipeline::TableInterface::winkler;
  study.table.substrate = pipeline::TableSubstrate::rigid;
  study.table.foundation_modulus = 1e10;
  return study;
}

} // namespace stemware::test
