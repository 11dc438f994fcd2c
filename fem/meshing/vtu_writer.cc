#include "fem/meshing/vtu_writer.h"

#include <array>

namespace stemware::fem
{

namespace
{

constexpr std::uint8_t hexahedron = 12, triquadratic_hexahedron = 29;

/// Appends the Base64 code of @p bytes (RFC 4648).
void append_base64(const std::vector<unsigned char> &bytes, std::string &text)
{
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i)
  { return i < bytes.size() ? static_cast<unsigned int>(bytes[i]) : 0U; };
  std::size_t end = text.size();
  text.resize(end + 4 * ((bytes.size() + 2) / 3), '=');
  for (std::size_t i = 0; i < bytes.size(); i += 3, end += 4)
  {
    const unsigned int bits = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    text[end] = digits[bits >> 18U];
    text[end + 1] = digits[bits >> 12U & 63U];
    if (i + 1 < bytes.size())
      text[end + 2] = digits[bits >> 6U & 63U];
    if (i + 2 < bytes.size())
      text[end + 3] = digits[bits & 63U];
  }
}

/// Appends an array to the text of a file, with its length before it.
template <typename Number>
void append_array(const std::string &name, unsigned int n_components, const std::vector<Number> &values,
                  std::string &text)
{
  const std::uint64_t n_bytes = values.size() * sizeof(Number);
  const auto *length = reinterpret_cast<const unsigned char *>(&n_bytes);
  const auto *data = reinterpret_cast<const unsigned char *>(values.data());
  std::vector<unsigned char> bytes(length, length + sizeof(n_bytes));
  bytes.insert(bytes.end(), data, data + n_bytes);
  const std::string type = std::is_same_v<Number, float>          ? "Float32"
                           : std::is_same_v<Number, std::int32_t> ? "Int32"
                                                                  : "UInt8";
  text += "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
          std::to_string(n_components) + "\" format=\"binary\">";
  append_base64(bytes, text);
  text += "</DataArray>\n";
}

} // namespace

VtuWriter::VtuWriter(unsigned int n_nodes)
    : n_nodes(n_nodes)
{
}

unsigned int VtuWriter::place(unsigned int i, unsigned int j, unsigned int k) const
{
  // Corners first, then edges, faces and the middle, as vtkTriQuadraticHexahedron lists them; [k][j][i].
  static constexpr std::array<unsigned int, 8> of_8 = { 0, 1, 3, 2, 4, 5, 7, 6 };
  static constexpr std::array<unsigned int, 27> of_27 = { 0,  8,  1,  11, 24, 9,  3,  10, 2,  //
                                                          16, 22, 17, 20, 26, 21, 19, 23, 18, //
                                                          4,  12, 5,  15, 25, 13, 7,  14, 6 };
  return n_nodes == 8 ? of_8[4 * k + 2 * j + i] : of_27[9 * k + 3 * j + i];
}

void VtuWriter::add_field(const std::string &name, unsigned int n_components, std::vector<float> values)
{
  fields.push_back({ name, n_components, std::move(values) });
}

std::string VtuWriter::text(const std::vector<float> &points, const std::vector<std::int32_t> &cells) const
{
  const std::size_t n_cells = cells.size() / n_nodes;
  std::vector<std::int32_t> ends(n_cells);
  for (std::size_t i = 0; i < n_cells; ++i)
    ends[i] = static_cast<std::int32_t>((i + 1) * n_nodes);
  const std::vector<std::uint8_t> types(n_cells, n_nodes == 8 ? hexahedron : triquadratic_hexahedron);
  std::string text =
    "<?xml version=\"1.0\"?>\n<!-- written by Stemware -->\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
    std::to_string(points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(n_cells) + "\">\n<Points>\n";
  append_array("points", 3, points, text);
  text += "</Points>\n<Cells>\n";
  append_array("connectivity", 1, cells, text);
  append_array("offsets", 1, ends, text);
  append_array("types", 1, types, text);
  text += "</Cells>\n<PointData>\n";
  for (const Field &field : fields)
    append_array(field.name, field.n_components, field.values, text);
  text += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

} // namespace stemware::fem
