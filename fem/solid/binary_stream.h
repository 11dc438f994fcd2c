#pragma once

#include <istream>
#include <ostream>

namespace stemware::fem
{

/// @p n numbers as they lie in memory.
template <typename Number>
void write_binary(std::ostream &stream, const Number *numbers, std::size_t n)
{
  stream.write(reinterpret_cast<const char *>(numbers), static_cast<std::streamsize>(n * sizeof(Number)));
}

template <typename Number>
void read_binary(std::istream &stream, Number *numbers, std::size_t n)
{
  stream.read(reinterpret_cast<char *>(numbers), static_cast<std::streamsize>(n * sizeof(Number)));
}

} // namespace stemware::fem
