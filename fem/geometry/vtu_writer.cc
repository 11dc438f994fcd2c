#include "fem/geometry/vtu_writer.h"

#include <array>

namespace stemware::fem
{

namespace
{

constexpr std::uint8_t hexahedron = 12, triquadratic_hexahedron = 29;

/// The arrays at the end of a file, and the elements that point to them.
class AppendedArrays
{
public:
  template <typename Number>
  std::string element(const std::string &name, unsigned int n_components, const std::vector<Number> &values)
  {
    const std::uint64_t n_bytes = values.size() * sizeof(Number);
    const std::string type = std::is_same_v<Number, float>          ? "Float32"
                             : std::is_same_v<Number, std::int32_t> ? "Int32"
                                                                    : "UInt8";
    std::string text = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                       std::to_string(n_components) + "\" format=\"appended\" offset=\"" +
                       std::to_string(bytes.size()) + "\"/>\n";
    bytes.append(reinterpret_cast<const char *>(&n_bytes), sizeof(n_bytes));
    bytes.append(reinterpret_cast<const char *>(values.data()), n_bytes);
    return text;
  }

  std::string bytes;
};

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
  AppendedArrays arrays;
  std::string text =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
    std::to_string(points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(n_cells) + "\">\n";
  text += "<Points>\n" + arrays.element("points", 3, points) + "</Points>\n";
  text += "<Cells>\n" + arrays.element("connectivity", 1, cells) + arrays.element("offsets", 1, ends) +
          arrays.element("types", 1, types) + "</Cells>\n<PointData>\n";
  for (const Field &field : fields)
    text += arrays.element(field.name, field.n_components, field.values);
  text += "</PointData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  return text + arrays.bytes + "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace stemware::fem
