#pragma once

#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/support/stopwatch.h"

#include <string>

namespace stemware::pipeline
{

/// What is pressed on the table, or the file that says so: one line.
void print_load_source(const Study &study);

/// Shows what is known of a foot, the contact steps, and what else happens while a study is solved, and keeps
/// the times; both must outlive the observer.
StudyObserver progress_on_console(Stopwatch &stopwatch);

/// The answer in sentences, and the table of truncations.
void print_answer(const Study &study, const StudyResult &result);

} // namespace stemware::pipeline
