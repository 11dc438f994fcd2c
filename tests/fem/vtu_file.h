#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>
#include <zlib.h>

namespace stemware::fem_tests
{

/// Arrays of a VTU file of one piece, zlib-compressed base64 as written by deal.II.
class VtuFile
{
public:
  explicit VtuFile(const std::string &text)
  {
    for (std::size_t at = text.find("<DataArray"); at != std::string::npos;
         at = text.find("<DataArray", at + 1))
    {
      const std::size_t begin = text.find('>', at) + 1;
      const std::string tag = text.substr(at, begin - at);
      const bool is_point_list = text.rfind("<Points>", at) != std::string::npos && !has(tag, "Name=");
      const std::string name = is_point_list ? "points" : attribute(tag, "Name");
      const std::string body = text.substr(begin, text.find('<', begin) - begin);
      const std::string bytes = inflated(body);
      if (has(tag, "Float32"))
        numbers[name] = converted<float>(bytes);
      else if (has(tag, "Int32"))
        numbers[name] = converted<std::int32_t>(bytes);
      else if (has(tag, "UInt8"))
        numbers[name] = converted<std::uint8_t>(bytes);
      else
        throw std::runtime_error("an array of another type: " + tag);
    }
  }

  const std::vector<double> &array(const std::string &name) const { return numbers.at(name); }
  std::size_t n_points() const { return array("points").size() / 3; }
  std::size_t n_cells() const { return array("types").size(); }

private:
  static bool has(const std::string &tag, const std::string &word)
  {
    return tag.find(word) != std::string::npos;
  }

  static std::string attribute(const std::string &tag, const std::string &name)
  {
    const std::size_t begin = tag.find(name + "=\"") + name.size() + 2;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  static std::string decoded(const std::string &base64)
  {
    static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::size_t> values(256, std::string::npos);
    for (std::size_t i = 0; i < letters.size(); ++i)
      values[static_cast<unsigned char>(letters[i])] = i;
    std::string bytes;
    std::uint32_t bits = 0;
    unsigned int n_bits = 0;
    for (const char letter : base64)
    {
      const std::size_t value = values[static_cast<unsigned char>(letter)];
      if (value == std::string::npos)
        continue; // white space and padding
      bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
      n_bits += 6;
      if (n_bits >= 8)
      {
        n_bits -= 8;
        bytes += static_cast<char>(bits >> n_bits & 0xff);
      }
    }
    return bytes;
  }

  /// Returns the decompressed data of @p body, which begin with a header: number of blocks, block size, size
  /// of the last block, compressed size.
  static std::string inflated(const std::string &body)
  {
    const std::size_t begin = body.find_first_not_of(" \n\t");
    const std::string head = decoded(body.substr(begin, 24));
    std::uint32_t header[4];
    std::memcpy(header, head.data(), sizeof(header));
    const std::string packed = decoded(body.substr(begin + 24));
    std::string bytes(header[1], ' ');
    uLongf size = bytes.size();
    if (header[0] != 1 || uncompress(reinterpret_cast<Bytef *>(bytes.data()), &size,
                                     reinterpret_cast<const Bytef *>(packed.data()), header[3]) != Z_OK)
      throw std::runtime_error("an array that zlib does not read");
    return bytes;
  }

  template <typename Number>
  static std::vector<double> converted(const std::string &bytes)
  {
    std::vector<Number> raw(bytes.size() / sizeof(Number));
    std::memcpy(raw.data(), bytes.data(), raw.size() * sizeof(Number));
    return std::vector<double>(raw.begin(), raw.end());
  }

  std::map<std::string, std::vector<double>> numbers;
};

} // namespace stemware::fem_tests
