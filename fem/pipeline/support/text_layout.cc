#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
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

} // namespace

std::string in_percent(const std::optional<double> &share)
{
  return share ? formatted("%+.3g %%", 100 * *share) : "-";
}

std::string wrapped(const std::string &text, const std::string &label)
{
  const std::size_t indent = width_of(label);
  std::istringstream words(text);
  std::string lines = label;
  std::size_t column = indent;
  for (std::string word; words >> word; column += width_of(word))
  {
    if (column > indent && column + 1 + width_of(word) > console_width)
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

} // namespace stemware::pipeline
