#include "fem/pipeline/report/render/marked_text.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <regex>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Entities of characters that mean something to HTML; the one that all begin with comes last.
const std::vector<std::pair<std::string, std::string>> entities = { { "&lt;", "<" },
                                                                    { "&gt;", ">" },
                                                                    { "&quot;", "\"" },
                                                                    { "&#39;", "'" },
                                                                    { "&amp;", "&" } };

bool is_word(const std::string &text, std::size_t i)
{
  return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i]));
}

/// Whether a symbol of one letter ends before @p end. Bytes beyond ASCII belong to Greek letters.
bool ends_symbol(const std::string &text, std::size_t end)
{
  if (end == 0)
    return false;
  return static_cast<unsigned char>(text[end - 1]) >= 128 ||
         (is_word(text, end - 1) && (end == 1 || (!is_word(text, end - 2) && text[end - 2] != '_')));
}

/// A text with its subscripts between @p begin and @p end instead of after an underscore, and all pieces
/// escaped by @p safe.
std::string with_subscripts(const std::string &text, std::string (*safe)(const std::string &),
                            const std::string &begin, const std::string &end)
{
  std::string marked;
  std::size_t written = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '_' && ends_symbol(text, i) && is_word(text, i + 1))
    {
      marked += safe(text.substr(written, i - written));
      const std::size_t first = i + 1;
      while (is_word(text, i + 1))
        ++i;
      written = i + 1;
      marked += begin + safe(text.substr(first, written - first)) + end;
    }
  return marked + safe(text.substr(written));
}

/// Text within gnuplot's single quotes without characters that end them or that its markup interprets. In
/// single quotes neither backticks nor backslashes nor @ mean anything to gnuplot itself; a line end would
/// begin a command.
std::string quotable(const std::string &text)
{
  std::string quoted;
  for (const char character : text)
  {
    if (std::string("_^{}@&~\\").find(character) != std::string::npos)
      quoted += '\\'; // for the markup
    else if (character == '\'')
      quoted += '\'';
    quoted += std::iscntrl(static_cast<unsigned char>(character)) ? ' ' : character;
  }
  return quoted;
}

/// HTML with its numbers in powers of ten as print has them, 3.4 · 10⁻⁶ for 3.4e-06.
std::string with_powers(const std::string &html)
{
  std::string result;
  std::size_t written = 0;
  for (std::size_t e = html.find('e', 1); e < html.size(); e = html.find('e', e + 1))
  {
    const std::size_t begin = html.find_last_not_of("0123456789.", e - 1) + 1;
    const std::size_t end = std::min(html.find_first_not_of("0123456789", e + 2), html.size());
    const bool has_sign = e + 1 < html.size() && (html[e + 1] == '+' || html[e + 1] == '-');
    if (begin == e || begin < written || !has_sign || end == e + 2)
      continue;
    const std::string factor = html.substr(begin, e - begin);
    const std::size_t exponent = std::min(html.find_first_not_of('0', e + 2), end - 1);
    result += html.substr(written, begin - written) + (factor == "1" ? "" : factor + " · ") + "10<sup>" +
              (html[e + 1] == '-' ? "\u2212" : "") + html.substr(exponent, end - exponent) + "</sup>";
    written = end;
  }
  return result + html.substr(written);
}

} // namespace

std::string html_text(const std::string &text)
{
  std::string safe;
  for (const char character : text)
  {
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [=](const auto &entity) { return entity.second[0] == character; });
    safe += found == entities.end() ? std::string(1, character) : found->first;
  }
  return safe;
}

std::string plain_text(const std::string &html)
{
  std::string text = html;
  for (const auto &[entity, character] : entities)
    boost::replace_all(text, entity, character);
  return text;
}

std::string html_formula(const std::string &text)
{
  return with_subscripts(text, html_text, "<sub>", "</sub>");
}

std::string with_true_minus(const std::string &text)
{
  static const std::regex minus("(^|[\\s(\\[<>=±≤,])-(?=[0-9])");
  return std::regex_replace(text, minus, "$1\u2212");
}

bool is_number(const std::string &cell)
{
  const std::size_t digit = cell.find_first_not_of("+-");
  return cell.empty() || cell == "–" ||
         (digit != std::string::npos && digit < 2 && std::isdigit(static_cast<unsigned char>(cell[digit])));
}

std::string in_form(const std::string &text, const std::string &form)
{
  if (form == "formula")
    return html_formula(text);
  if (form == "flowing")
  {
    std::string html = with_true_minus(html_formula(text));
    for (const std::string unit : { "%", "rad/s" })
      boost::replace_all(html, " " + unit, "\u00a0" + unit);
    return html;
  }
  if (form != "cell")
    return text;
  const std::string html = html_formula(text);
  return with_true_minus(is_number(text) ? with_powers(html) : html);
}

std::string gnuplot_text(const std::string &text)
{
  return '\'' + with_subscripts(text, quotable, "_{", "}") + '\'';
}

} // namespace stemware::pipeline
