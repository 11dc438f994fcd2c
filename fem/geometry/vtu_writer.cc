#include "fem/geometry/vtu_writer.h"

#include <array>

namespace stemware::fem
{

namespace
{

constexpr std::uint8_t hexahedron = 12, triquadratic_hexahedron = 29;

void append_base64(const std::string &bytes, std::string &text)
{
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t n_whole = bytes.size() / 3, n_left = bytes.size() % 3, begin = text.size();
  text.resize(begin + 4 * (n_whole + (n_left > 0 ? 1 : 0)));
  const auto *from = reinterpret_cast<const unsigned char *>(bytes.data());
  char *to = text.data() + begin;
  const auto put = [&](unsigned int first, unsigned int second, unsigned int third)
  {
    const unsigned int bits = first << 16 | second << 8 | third;
    for (const int shift : { 18, 12, 6, 0 })
      *to++ = letters[bits >> shift & 63];
  };
  for (std::size_t i = 0; i < n_whole; ++i, from += 3)
    put(from[0], from[1], from[2]);
  if (n_left == 0)
    return;
  put(from[0], n_left == 2 ? from[1] : 0, 0);
  text.replace(text.size() - (3 - n_left), 3 - n_left, 3 - n_left, '=');
}

/// Appends an array to the text of a file, with its length before it.
template <typename Number>
void append_array(const std::string &name, unsigned int n_components, const std::vector<Number> &values,
                  std::string &text)
{
  const std::uint64_t n_bytes = values.size() * sizeof(Number);
  std::string bytes(reinterpret_cast<const char *>(&n_bytes), sizeof(n_bytes));
  bytes.append(reinterpret_cast<const char *>(values.data()), n_bytes);
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
    "<?xml version=\"1.0\"?>\n"
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
  return text + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace stemware::fem
