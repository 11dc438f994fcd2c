#pragma once

#include "tests/fem/pipeline/program_runner.h"

#include <string>
#include <vector>

namespace stemware::test
{

/// Returns @p text as a string literal of a script within a page.
std::string script_string(const std::string &text);

/// Returns @p text with single blanks between words and ASCII minus signs, as on the console.
std::string in_one_line(const std::string &text);

/// Returns a script that defines `serious(window)`: a promise of the serious and critical accessibility
/// violations found by axe-core, as strings; empty without axe-core.
std::string axe_script();

/// Returns a script that defines `troubles(document)`: a sentence for each figure text that is cut off or
/// overlaps another text, each axis with a single number, and each element that is wider than the page.
std::string troubles_script();

/// Returns a text of scripts, commands, closing tags, quotes and template marks. If one of the scripts runs,
/// it sets data-ran of the root element. In a path, the slashes of the text separate folders.
std::string hostile_text();

/// Returns the first lines of a script, which open @p page in a frame of width @p width [px].
std::string framed(const std::string &page, int width);

/// Runs @p script, the body of an async function, in a page in Chromium and returns its result. Files in @p
/// scratch have the same origin. Fails the test if the browser prints a message, unless @p forbids is true: a
/// policy then forbids an action of the script.
nlohmann::json found_in_browser(const ScratchFolder &scratch, const std::string &script,
                                bool forbids = false);

/// Opens pages (@p addresses relative to @p scratch), each in its own frame. Returns by address "answer",
/// "words" (all texts), and "ran" (true if a script of hostile_text() ran).
nlohmann::json opened_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses);

/// Opens reports (@p addresses relative to @p scratch) with all folds open. Returns by address: "answer";
/// "flaws", a sentence for each defect (unfinished script, NaN, invalid SVG file, serious finding of
/// axe-core, layout trouble at 1100 and 400 px, network request); "figures", by id the rows of the CSV file;
/// "tables", by title the rows.
nlohmann::json reports_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses);

/// Returns the page without its Content-Security-Policy. Hostile text must be harmless without the policy,
/// too.
std::string without_policy(const std::string &page);

Ended chromium(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

} // namespace stemware::test
