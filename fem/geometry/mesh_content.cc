#include "fem/geometry/mesh_content.h"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <charconv>

namespace stemware::fem
{

namespace
{

constexpr std::string_view blanks = " \t\r\n\f\v";

template <typename Number>
std::optional<Number> whole_word(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    return std::nullopt;
  return value;
}

[[noreturn]] void refuse_word(std::string_view word)
{
  if (word.empty())
    throw UnreadableMesh("ends too early; export the mesh anew.");
  throw UnreadableMesh("has \"" + printable(word, 20) + "\" where a number belongs; export the mesh anew.");
}

} // namespace

std::string printable(std::string_view text, std::size_t max_length)
{
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string shown;
  for (auto here = text.begin(); here != text.end() && max_length > 0; --max_length)
  {
    const auto start = here;
    const boost::locale::utf::code_point letter = Utf8::decode(here, text.end());
    const bool is_control = letter < 0x20 || (letter >= 0x7f && letter < 0xa0);
    if (boost::locale::utf::is_valid_codepoint(letter) && !is_control)
      shown.append(start, here);
    else
      shown += '?';
  }
  return shown;
}

std::optional<long> whole_number_in(std::string_view word)
{
  return whole_word<long>(word);
}

std::string_view Tokenizer::next()
{
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
  rest.remove_prefix(word.size());
  return word;
}

void Tokenizer::skip_line()
{
  rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
}

double Tokenizer::number()
{
  const std::string_view word = next();
  if (const auto value = whole_word<double>(word))
    return *value;
  refuse_word(word);
}

long Tokenizer::whole_number()
{
  const std::string_view word = next();
  if (const auto value = whole_number_in(word))
    return *value;
  refuse_word(word);
}

void NumberedPoints::add(long number, const std::array<double, 3> &point)
{
  if (!index.emplace(number, static_cast<unsigned int>(points.size())).second)
    throw UnreadableMesh("has two nodes of the number " + std::to_string(number) + "; export one part.");
  points.push_back(point);
}

unsigned int NumberedPoints::at(long number) const
{
  const auto found = index.find(number);
  if (found == index.end())
    throw UnreadableMesh("has an element at node " + std::to_string(number) +
                         ", which it does not have; export the mesh anew.");
  return found->second;
}

} // namespace stemware::fem
