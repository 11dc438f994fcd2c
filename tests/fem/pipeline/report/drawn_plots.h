#pragma once

#include "fem/pipeline/report/document.h"
#include "fem/pipeline/report/results.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Pictures of documents made by hand, drawn by gnuplot.
namespace stemware::test
{

/// The picture of a document whose facts are all there.
inline pipeline::Plot picture(const pipeline::Document &document, const std::string &name,
                              const std::string &source = "")
{
  return picture_of(document, document.facts, name, source.empty() ? name : source);
}

/// Draws plots, of which one may draw another's data, and says what went wrong.
inline std::string draw(const std::vector<pipeline::Plot> &plots, const ScratchFolder &scratch)
{
  testing::internal::CaptureStderr();
  pipeline::write_report({ "Plots", "", { { "The plots", "", plots } } }, scratch.path());
  return testing::internal::GetCapturedStderr();
}

inline std::string draw(const pipeline::Plot &plot, const ScratchFolder &scratch)
{
  return draw(std::vector<pipeline::Plot>{ plot }, scratch);
}

/// What the text of the plot's SVG says, markup left out.
inline std::string words_of(const pipeline::Plot &plot, const ScratchFolder &scratch)
{
  const std::string svg = read_text(scratch / ("figures/" + plot.name + ".svg"));
  std::string words;
  bool inside = true;
  for (const char character : svg)
    if (character == '<' || character == '>')
      inside = character == '>';
    else if (inside)
      words += character;
  return words;
}

} // namespace stemware::test
