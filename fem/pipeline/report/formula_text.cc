#include "fem/pipeline/report/formula_text.h"

#include <cctype>

namespace stemware::pipeline
{

namespace
{

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

} // namespace

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

} // namespace stemware::pipeline
