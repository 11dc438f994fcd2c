#include "fem/pipeline/support/spelling.h"

#include <algorithm>
#include <cctype>

namespace stemware::pipeline
{

std::size_t edit_distance(const std::string &from, const std::string &to)
{
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j)
    {
      const bool equal = std::tolower(from[i - 1]) == std::tolower(to[j - 1]);
      const std::size_t replaced = diagonal + (equal ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ row[j] + 1, row[j - 1] + 1, replaced });
    }
  }
  return row.back();
}

std::optional<std::string> likeliest(const std::string &word, const std::vector<std::string> &words)
{
  constexpr std::size_t most_slips = 3;
  std::optional<std::string> best;
  std::size_t least = most_slips + 1;
  for (const std::string &candidate : words)
  {
    const std::size_t distance = edit_distance(word, candidate);
    // A word of which no letter is left is another word.
    if (distance < least && distance < candidate.size())
    {
      best = candidate;
      least = distance;
    }
  }
  return best;
}

} // namespace stemware::pipeline
