#pragma once

#include "tests/fem/pipeline/program_runner.h"

#include <string>
#include <vector>

namespace stemware::test
{

/// A text as a string of a script within a page.
std::string script_string(const std::string &text);

/// Returns a script that defines `serious(window)`: a promise of the accessibility violations that axe-core
/// finds serious or critical, a string for each. Without axe-core the promise is an empty list; the test
/// Reports.AxeCoreIsInstalledLong fails then.
std::string axe_script();

/// Returns a script that defines `troubles(document)`: a sentence for each text of a figure that is cut off
/// or lies on another, each axis with one number only, and each element that is wider than the page.
std::string troubles_script();

/// A text that would run a script or a command, end an element or a string, or be taken for a mark of a
/// template, if anything but its characters were looked at. A script that it runs sets data-ran of the page's
/// root element. It is a path without the name of its file: folders parted by the slashes of its tags.
std::string hostile_text();

/// Opens a page in Chromium that runs @p script, the body of an async function, and returns what the script
/// returns. Fails the test if the browser prints anything else, unless a policy @p forbids something, which
/// the browser prints. Files next to @p scratch's page are of one origin with it.
nlohmann::json found_in_browser(const ScratchFolder &scratch, const std::string &script,
                                bool forbids = false);

/// Opens pages, addresses relative to @p scratch, each in a frame of its own, until it has its answer or half
/// a minute has passed. Returns by address its "answer", all its "words", and whether a script of
/// hostile_text() "ran".
nlohmann::json opened_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses);

/// Opens reports, addresses relative to @p scratch, with all folds open. Returns by address: "answer";
/// "flaws", a sentence for each thing that no page may have (a script that has not ended, a number that is
/// none, a file of a picture that is no SVG, serious findings of axe-core, troubles at 1100 and 400 px, a
/// request); "figures", by id the rows of its CSV file; "tables", by title its rows of texts.
nlohmann::json reports_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses);

/// The page without its Content-Security-Policy: what it runs then has to be harmless by itself.
std::string without_policy(const std::string &page);

/// Runs Chromium without a window in the folder.
Ended chromium(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

} // namespace stemware::test
