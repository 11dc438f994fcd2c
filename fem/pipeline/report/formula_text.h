#pragma once

#include <string>

namespace stemware::pipeline
{

/// A text with its subscripts between @p begin and @p end instead of after an underscore, and all pieces
/// escaped by @p safe. Subscripts are the letters and digits after an underscore that follows a symbol of one
/// letter, Latin or Greek (τ_z, a_10, z_CM); the underscores of spin_up.csv are none.
std::string with_subscripts(const std::string &text, std::string (*safe)(const std::string &),
                            const std::string &begin, const std::string &end);

} // namespace stemware::pipeline
