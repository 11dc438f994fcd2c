#include "fem/pipeline/support/failures.h"

#include <sstream>

namespace stemware::pipeline
{

void require(bool condition, const std::string &sentence)
{
  if (!condition)
    throw BadInput(sentence);
}

std::string on_one_line(const std::string &text)
{
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

} // namespace stemware::pipeline
