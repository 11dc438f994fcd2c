#pragma once

#include "ring_model/load/require.h"

namespace stemware::fem
{

using ring::require;
using ring::sentence;

} // namespace stemware::fem
