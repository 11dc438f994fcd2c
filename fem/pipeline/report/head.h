#pragma once

#include "fem/pipeline/report/document.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/load/ring_stack.h"

#include <optional>
#include <string>
#include <vector>

/// The head of a report: what was computed, as a line of inputs, a sketch with its numbers and glasses that
/// go round their orbit.
namespace stemware::pipeline
{

struct StudyEntry;

/// A number in the unit, of those that people use beside the SI unit @p unit, that makes it short: "300 g".
std::string in_words(double value, const std::string &unit);

/// The value of an entry of @p study as its user wrote it, "300 g"; of one that nobody gave, or gave without
/// a unit, in the unit that makes it short.
std::string in_words(const Study &study, const StudyEntry &entry);

/// A glass on its orbit, seen from above.
struct TurningGlass
{
  std::string title;
  std::optional<double> omega = {};         ///< [rad/s]; nothing: it has no terminal spin
  std::optional<ring::RingStack> load = {}; ///< how hard the rim presses; nothing: not shown
  bool is_ring = false;                     ///< a ring alone, without a foot
};

/// Adds to @p document what the templates inputs, glass, orbits and study show of @p study: study_title,
/// given (the values of its entries in words, by their paths), hand,
/// table and sketch, in "orbits" the @p glasses on the orbit of the study, and its entries, those that are
/// not the defaults beside all of them. @p load is that of rest.
void add_study(const Study &study, const std::vector<TurningGlass> &glasses, Document &document,
               const std::optional<ring::RingStack> &load = {});

} // namespace stemware::pipeline
