#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stemware::fem
{

/// VTU file of one piece: points, hexahedra with 8 or 27 nodes, and fields at the points, in single
/// precision, base64-encoded. (Appended raw data would be a quarter shorter, but the XML parser of Debian
/// 12's ParaView cannot read it.)
class VtuWriter
{
public:
  /// Cells of @p n_nodes nodes each: 8 (VTK_HEXAHEDRON) or 27 (VTK_TRIQUADRATIC_HEXAHEDRON).
  explicit VtuWriter(unsigned int n_nodes);

  /// Returns the position in a cell's list of its node (i, j, k), each from 0 to 1 (8 nodes) or 2 (27).
  unsigned int place(unsigned int i, unsigned int j, unsigned int k) const;

  /// File: @p points, x y z of each [m], and @p cells, the points of each in the order of place().
  std::string text(const std::vector<float> &points, const std::vector<std::int32_t> &cells) const;

  /// Field for the file: @p values has @p n_components numbers a point.
  void add_field(const std::string &name, unsigned int n_components, std::vector<float> values);

private:
  struct Field
  {
    std::string name;
    unsigned int n_components;
    std::vector<float> values;
  };

  const unsigned int n_nodes;
  std::vector<Field> fields;
};

} // namespace stemware::fem
