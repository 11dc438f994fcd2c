#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A piece of a plain text, to be written as it is or as a subscript.
struct TextPiece
{
  std::string text;
  bool subscript = false;
};

/// Splits a text at its subscripts: the letters and digits after an underscore that follows a symbol of one
/// letter, Latin or Greek (τ_z, a_10, z_CM). The underscores of spin_up.dat are none.
std::vector<TextPiece> formula_pieces(const std::string &text);

} // namespace stemware::pipeline
