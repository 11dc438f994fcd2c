#include "fem/pipeline/base/text.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Returns the edit distance: the minimum number of letters to insert, delete or replace, ignoring case.
std::size_t edit_distance(const std::string &from, const std::string &to)
{
  const auto lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= from.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j)
    {
      const bool equal = lower(from[i - 1]) == lower(to[j - 1]);
      const std::size_t replaced = diagonal + (equal ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ row[j] + 1, row[j - 1] + 1, replaced });
    }
  }
  return row.back();
}

} // namespace

std::size_t display_width(const std::string &text)
{
  return static_cast<std::size_t>(
    std::count_if(text.begin(), text.end(), [](char letter) { return (letter & 0xC0) != 0x80; }));
}

std::string wrapped(const std::string &text, const std::string &label, std::size_t width)
{
  const std::size_t indent = display_width(label);
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    if (!words.empty() && (word.rfind('%', 0) == 0 || word.rfind("rad/s", 0) == 0))
      words.back() += ' ' + word; // keeps a number and its unit together
    else
      words.push_back(word);
  std::string lines = label;
  std::size_t column = indent;
  for (const std::string &word : words)
  {
    if (column > indent && column + 1 + display_width(word) > width)
    {
      lines += '\n' + std::string(indent, ' ');
      column = indent;
    }
    else if (column > indent)
    {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += display_width(word);
  }
  return lines;
}

std::string listed(const std::vector<std::string> &words, const std::string &last)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? ' ' + last + ' ' : ", ") + words[i];
  return text;
}

std::string filled(const std::string &pattern, const std::vector<std::string> &words)
{
  std::string text;
  std::size_t begin = 0;
  for (const std::string &word : words)
  {
    const std::size_t place = pattern.find("{}", begin);
    text += pattern.substr(begin, place - begin) + word;
    begin = place + 2;
  }
  return text + pattern.substr(begin);
}

std::string csv_field(const std::string &text)
{
  if (text.find_first_of(",\"#\r\n") == std::string::npos)
    return text;
  return '"' + boost::replace_all_copy(text, "\"", "\"\"") + '"';
}

std::optional<std::string> closest_match(const std::string &word, const std::vector<std::string> &words)
{
  constexpr std::size_t max_slips = 3;
  std::optional<std::string> best;
  std::size_t least = max_slips + 1;
  for (const std::string &candidate : words)
  {
    const std::size_t shorter = std::min(word.size(), candidate.size());
    if (std::max(word.size(), candidate.size()) - shorter > max_slips)
      continue; // the distance is at least the difference in length
    const std::size_t distance = edit_distance(word, candidate);
    // A candidate that differs in every letter cannot result from a typing error.
    if (distance < least && distance < candidate.size())
    {
      best = candidate;
      least = distance;
    }
  }
  return best;
}

} // namespace stemware::pipeline
