#pragma once

#include "tests/fem/pipeline/program_runner.h"

#include <string>
#include <vector>

namespace stemware::test
{

/// A text as a string of a script within a page.
std::string script_string(const std::string &text);

/// A script that defines `serious(window)`: a promise of what axe-core (it looks for what keeps people from
/// reading a page) finds serious or critical, a string for each; of nothing where it is not installed.
std::string axe_script();

/// Runs Chromium without a window in the folder.
Ended chromium(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

} // namespace stemware::test
