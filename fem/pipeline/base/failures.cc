#include "fem/pipeline/base/failures.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim_all.hpp>

namespace stemware::pipeline
{

void ensure(bool condition, const std::string &sentence)
{
  if (!condition)
    throw BadInput(sentence);
}

std::string on_one_line(const std::string &text)
{
  // A control character could end a message or move the cursor.
  return boost::trim_fill_copy_if(text, " ", boost::is_space() || boost::is_cntrl());
}

std::string shortened(const std::string &text, std::size_t longest)
{
  // Cuts long texts before their characters are counted. A UTF-8 character has at most four bytes.
  std::string line = on_one_line(text.substr(0, 4 * longest + 4));
  std::size_t n_characters = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if ((line[i] & 0xC0) != 0x80 && ++n_characters > longest)
      return line.substr(0, i) + "...";
  return text.size() > 4 * longest + 4 ? line + "..." : line;
}

std::string shortened_path(const std::string &path)
{
  constexpr std::size_t longest = 80;
  if (path.size() <= longest)
    return on_one_line(path);
  std::size_t begin = path.size() - longest + 3;
  while (begin < path.size() && (path[begin] & 0xC0) == 0x80)
    ++begin;
  return "..." + on_one_line(path.substr(begin));
}

} // namespace stemware::pipeline
