#include "fem/pipeline/report/results.h"

#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/text.h"

#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Lines that fit the console as they are, longer ones wrapped.
std::string wrapped_lines(const std::string &text)
{
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += (line.size() <= console_width ? line : wrapped(line)) + '\n';
  return result;
}

} // namespace

std::string console_text(const Results &results)
{
  std::string text;
  for (const ConsoleBlock &block : results.console)
  {
    if (!block.text.empty())
      text += '\n' + wrapped_lines(block.text);
    if (block.table)
      text += '\n' + console_table(*block.table);
  }
  return text + '\n';
}

} // namespace stemware::pipeline
