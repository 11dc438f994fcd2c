#include "fem/pipeline/support/sentence.h"

#include <cstddef>

namespace stemware::pipeline
{

Sentence sentence(const std::string &key, const std::string &text, const std::vector<std::string> &values)
{
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '{')
      filled += text[i];
    else
    {
      filled += values.at(static_cast<std::size_t>(text.at(i + 1) - '0'));
      i += 2;
    }
  return { key, filled, values };
}

} // namespace stemware::pipeline
