#include "fem/pipeline/base/html.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace stemware::pipeline
{

std::string with_marks_replaced(const std::string &text, const std::map<std::string, std::string> &texts)
{
  const std::string begin = "/*", end = "*/";
  std::string result;
  std::size_t written = 0;
  for (std::size_t mark = text.find(begin); mark < text.size(); mark = text.find(begin, written))
  {
    const std::size_t name = mark + begin.size(), name_end = text.find(end, name);
    result += text.substr(written, mark - written) + texts.at(text.substr(name, name_end - name));
    written = name_end + end.size();
  }
  return result + text.substr(written);
}

std::string html_text(const std::string &text)
{
  std::string safe;
  for (const char character : text)
    if (character == '<')
      safe += "&lt;";
    else if (character == '>')
      safe += "&gt;";
    else if (character == '&')
      safe += "&amp;";
    else if (character == '"')
      safe += "&quot;";
    else if (character == '\'')
      safe += "&#39;";
    else
      safe += character;
  return safe;
}

std::string base64_of_digits(const std::string &digits)
{
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  return std::string(Letters(bytes.cbegin()), Letters(bytes.cend())) +
         std::string((3 - bytes.size() % 3) % 3, '=');
}

} // namespace stemware::pipeline
