#include "fem/pipeline/support/text.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

constexpr std::size_t margin = 2; ///< blanks before each column

/// Columns on the screen: the bytes that begin a character of UTF-8.
std::size_t width_of(const std::string &text)
{
  return static_cast<std::size_t>(
    std::count_if(text.begin(), text.end(), [](char letter) { return (letter & 0xC0) != 0x80; }));
}

std::vector<std::string> lines_of(const std::string &text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// A line of a column, blanks before it and beside it.
std::string padded(const std::string &line, std::size_t width, bool is_text)
{
  const std::string blanks(width - margin - width_of(line), ' ');
  return std::string(margin, ' ') + (is_text ? line + blanks : blanks + line);
}

/// A column as the lines that are printed, all equally wide; headers stand at the bottom of theirs.
struct LaidOutColumn
{
  LaidOutColumn(const TextColumn &column, std::size_t n_header_lines)
  {
    const std::vector<std::string> header = lines_of(column.header);
    lines.assign(n_header_lines - header.size(), "");
    lines.insert(lines.end(), header.begin(), header.end());
    lines.insert(lines.end(), column.cells.begin(), column.cells.end());
    for (const std::string &line : lines)
      width = std::max(width, width_of(line) + margin);
    for (std::string &line : lines)
      line = padded(line, width, column.is_text);
  }

  std::vector<std::string> lines;
  std::size_t width = 0;
};

/// The lines of some columns side by side, without blanks at their ends.
std::string side_by_side(const std::vector<const LaidOutColumn *> &columns)
{
  std::string text;
  for (std::size_t i = 0; i < columns.front()->lines.size(); ++i)
  {
    for (const LaidOutColumn *column : columns)
      text += column->lines[i];
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

/// A field of a CSV record, in quotes where it needs them.
std::string field(const std::string &text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

/// Number of letters to insert, delete or change to get from one word to the other, upper and lower case
/// being equal.
std::size_t edit_distance(const std::string &from, const std::string &to)
{
  const auto lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j)
    row[j] = j;
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

std::string in_percent(const std::optional<double> &share)
{
  return share ? fmt::format(FMT_STRING("{:+.3g} %"), 100 * *share) : "-";
}

std::string wrapped(const std::string &text, const std::string &label, std::size_t width)
{
  const std::size_t indent = width_of(label);
  std::istringstream words(text);
  std::string lines = label;
  std::size_t column = indent;
  for (std::string word; words >> word; column += width_of(word))
  {
    if (column > indent && column + 1 + width_of(word) > width)
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
  }
  return lines;
}

std::string text_table(const std::vector<TextColumn> &columns)
{
  std::size_t n_header_lines = 0;
  for (const TextColumn &column : columns)
    n_header_lines = std::max(n_header_lines, lines_of(column.header).size());
  std::vector<LaidOutColumn> laid_out;
  laid_out.reserve(columns.size());
  for (const TextColumn &column : columns)
    laid_out.emplace_back(column, n_header_lines);

  std::string text;
  std::vector<const LaidOutColumn *> block = { &laid_out.front() };
  std::size_t width = laid_out.front().width;
  for (std::size_t c = 1; c < laid_out.size(); ++c)
  {
    if (block.size() > 1 && width + laid_out[c].width > console_width)
    {
      text += side_by_side(block) + '\n';
      block = { &laid_out.front() };
      width = laid_out.front().width;
    }
    block.push_back(&laid_out[c]);
    width += laid_out[c].width;
  }
  return text + side_by_side(block);
}

std::string csv_record(const std::vector<std::string> &fields)
{
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i == 0 ? "" : ",") + field(fields[i]);
  return line + "\r\n";
}

std::string column_title(const std::string &name, const std::string &unit)
{
  return unit.empty() ? name : name + " (" + unit + ")";
}

std::optional<std::string> likeliest(const std::string &word, const std::vector<std::string> &words)
{
  constexpr std::size_t most_slips = 3;
  std::optional<std::string> best;
  std::size_t least = most_slips + 1;
  for (const std::string &candidate : words)
  {
    const std::size_t shorter = std::min(word.size(), candidate.size());
    if (std::max(word.size(), candidate.size()) - shorter > most_slips)
      continue; // and a megabyte need not be compared
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
