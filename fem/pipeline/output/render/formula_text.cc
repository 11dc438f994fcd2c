#include "fem/pipeline/output/render/formula_text.h"

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

std::vector<TextPiece> formula_pieces(const std::string &text)
{
  std::vector<TextPiece> pieces = { {} };
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] == '_' && ends_symbol(text, i) && is_word(text, i + 1))
    {
      std::size_t end = i + 1;
      while (is_word(text, end))
        ++end;
      pieces.push_back({ text.substr(i + 1, end - i - 1), true });
      pieces.emplace_back();
      i = end - 1;
    }
    else
      pieces.back().text += text[i];
  }
  return pieces;
}

} // namespace stemware::pipeline
