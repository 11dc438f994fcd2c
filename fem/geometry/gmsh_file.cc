#include "fem/geometry/mesh_content.h"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace stemware::fem
{

namespace
{

constexpr std::string_view blanks = " \t\r\n\f\v";

template <typename Number>
std::optional<Number> whole_word(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    return std::nullopt;
  return value;
}

class Tokenizer
{
public:
  explicit Tokenizer(std::string_view text)
      : rest(text)
  {
  }

  /// Returns the next word, or an empty string after the last word.
  std::string_view next()
  {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
  }

  void skip_line() { rest.remove_prefix(std::min(rest.find('\n'), rest.size())); }

  double number() { return next_value<double>(); }
  long whole_number() { return next_value<long>(); }

private:
  template <typename Number>
  Number next_value()
  {
    const std::string_view word = next();
    if (const auto value = whole_word<Number>(word))
      return *value;
    if (word.empty())
      throw UnreadableMesh("ends too early; export the mesh anew.");
    throw UnreadableMesh("has \"" + printable(word, 20) + "\" where a number belongs; export the mesh anew.");
  }

  std::string_view rest;
};

constexpr char advice[] =
  "export hexahedra (Mesh.RecombineAll) of first or second order in format 2 or 4, ASCII.";

std::string in_format_2()
{
  return std::string("; convert it: ") + gmsh_command + ".";
}

struct ElementType
{
  unsigned int n_nodes = 0;
  unsigned int n_corners = 0; ///< 8: hexahedron, 4: quadrilateral, 0: ignored element
};

const std::map<long, ElementType> gmsh_types = { { 15, { 1, 0 } }, { 1, { 2, 0 } },  { 8, { 3, 0 } },
                                                 { 26, { 4, 0 } }, { 27, { 5, 0 } }, { 2, { 3, 0 } },
                                                 { 9, { 6, 0 } },  { 3, { 4, 4 } },  { 10, { 9, 4 } },
                                                 { 16, { 8, 4 } }, { 5, { 8, 8 } },  { 12, { 27, 8 } },
                                                 { 17, { 20, 8 } } };

ElementType type_of(long number)
{
  const auto type = gmsh_types.find(number);
  if (number == 6 || number == 13 || number == 18)
    throw UnreadableMesh(std::string("has wedges; ") + wedge_advice);
  if (type == gmsh_types.end())
    throw UnreadableMesh("has elements of Gmsh's type " + std::to_string(number) + "; " + advice);
  return type->second;
}

/// Returns the sections of the file (the texts between "$Name" and "$EndName"), by name.
std::map<std::string, std::string_view> sections_of_gmsh(std::string_view text)
{
  std::map<std::string, std::string_view> sections;
  while (true)
  {
    const std::size_t mark = text.find('$');
    if (mark == std::string_view::npos)
      return sections;
    text.remove_prefix(mark + 1);
    const std::string name(text.substr(0, std::min<std::size_t>(text.find_first_of(" \t\r\n"), 40)));
    text.remove_prefix(name.size());
    const std::size_t end = text.find("$End" + name);
    if (end == std::string_view::npos)
      throw UnreadableMesh("has no $End" + name.substr(0, 20) + "; export the mesh anew.");
    const bool is_data = name != "MeshFormat" && name != "Entities" && name != "Nodes" && name != "Elements";
    if (!sections.emplace(name, text.substr(0, end)).second && !is_data)
      throw UnreadableMesh("has two sections $" + name.substr(0, 20) + "; export the mesh anew.");
    text.remove_prefix(end + 4 + name.size());
  }
}

class GmshReader
{
public:
  explicit GmshReader(const std::string &text)
      : sections(sections_of_gmsh(text))
  {
  }

  MeshContent read()
  {
    read_format();
    read_names();
    if (is_format_4 && sections.count("Entities") > 0)
      read_surfaces();
    read_nodes();
    read_elements();
    return std::move(content);
  }

private:
  Tokenizer section(const std::string &name) const
  {
    const auto found = sections.find(name);
    if (found == sections.end())
      throw UnreadableMesh(std::string("is not a Gmsh .msh mesh of hexahedra; ") + advice);
    return Tokenizer(found->second);
  }

  void read_format()
  {
    Tokenizer words = section("MeshFormat");
    const std::string version(words.next());
    is_format_4_0 = version == "4" || version == "4.0";
    is_format_4 = is_format_4_0 || version == "4.1";
    if (!is_format_4 && version != "2" && version != "2.0" && version != "2.1" && version != "2.2")
      throw UnreadableMesh("is in Gmsh's format " + version.substr(0, 10) +
                           ", and 2.2, 4.0 and 4.1 are read" + in_format_2());
    if (words.next() != "0")
      throw UnreadableMesh("is binary, and ASCII is read" + in_format_2());
    if (sections.count("PartitionedEntities") > 0)
      throw UnreadableMesh("is partitioned, and a mesh in one part is read" + in_format_2());
  }

  /// Reads the names of the physical surface groups from lines such as: 2 7 "contact".
  void read_names()
  {
    const auto found = sections.find("PhysicalNames");
    std::string_view text = found == sections.end() ? "" : found->second;
    while (!text.empty())
    {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      Tokenizer words(line);
      const auto dimension = whole_word<long>(words.next()), id = whole_word<long>(words.next());
      const std::size_t begin = line.find('"'), end = line.rfind('"');
      if (dimension == 2 && id && *id > 0 && begin < end)
        content.names[static_cast<unsigned int>(*id)] = line.substr(begin + 1, end - begin - 1);
    }
  }

  void read_surfaces()
  {
    Tokenizer words = section("Entities");
    long n[3];
    for (long &n_entities : n)
      n_entities = words.whole_number();
    words.whole_number(); // skips the number of volumes
    for (int dimension = 0; dimension < 3; ++dimension)
      for (long i = 0; i < n[dimension]; ++i)
      {
        const long entity = words.whole_number();
        for (int k = 0; k < (dimension == 0 && !is_format_4_0 ? 3 : 6); ++k)
          words.number();
        const long n_physical = words.whole_number();
        for (long k = 0; k < n_physical; ++k)
        {
          const long id = std::labs(words.whole_number());
          if (dimension == 2 && !physical_id.emplace(entity, id).second)
            throw UnreadableMesh("has a surface with several physical ids; give each surface one.");
        }
        const long n_bounds = dimension == 0 ? 0 : words.whole_number();
        for (long k = 0; k < n_bounds; ++k)
          words.whole_number();
      }
  }

  /// Header of a block of nodes or elements. Format 4 has one block per entity, format 2 a single block.
  struct Block
  {
    long dimension = 0, entity = 0;
    long kind = 0; ///< element type; for nodes: nonzero if the nodes have parametric coordinates
    long size = 0;
  };

  long n_blocks(Tokenizer &words) const
  {
    if (!is_format_4)
      return 1;
    const long n = words.whole_number();
    // Skips the count of nodes or elements, and the smallest and the largest of their numbers.
    for (int k = 0; k < (is_format_4_0 ? 1 : 3); ++k)
      words.whole_number();
    return n;
  }

  Block next_block(Tokenizer &words) const
  {
    Block block;
    if (is_format_4)
    {
      block.dimension = words.whole_number();
      block.entity = words.whole_number();
      block.kind = words.whole_number();
    }
    if (is_format_4_0)
      std::swap(block.dimension, block.entity);
    block.size = words.whole_number();
    return block;
  }

  void read_nodes()
  {
    const bool have_parameters = sections.count("ParametricNodes") > 0; // format 2 only
    Tokenizer words = section(have_parameters ? "ParametricNodes" : "Nodes");
    for (long n = n_blocks(words); n > 0; --n)
    {
      const Block block = next_block(words);
      std::vector<long> numbers; // node numbers; in format 4.1 they precede the coordinates
      for (long i = 0; i < block.size && is_format_4 && !is_format_4_0; ++i)
        numbers.push_back(words.whole_number());
      for (long i = 0; i < block.size; ++i)
      {
        const long number = numbers.empty() ? words.whole_number() : numbers[static_cast<std::size_t>(i)];
        for (double &coordinate : content.points.emplace_back())
          coordinate = words.number();
        if (!index.emplace(number, static_cast<unsigned int>(index.size())).second)
          throw UnreadableMesh("has two nodes of the number " + std::to_string(number) +
                               "; export one part.");
        for (long k = 0; k < block.dimension && block.kind != 0; ++k)
          words.number();
        if (have_parameters)
          words.skip_line();
      }
    }
  }

  void read_elements()
  {
    Tokenizer words = section("Elements");
    for (long n = n_blocks(words); n > 0; --n)
    {
      const Block block = next_block(words);
      const auto surface = physical_id.find(block.entity);
      long id = surface == physical_id.end() ? 0 : surface->second;
      for (long i = 0; i < block.size; ++i)
      {
        words.whole_number(); // skips the number of the element
        const ElementType type = type_of(is_format_4 ? block.kind : words.whole_number());
        if (!is_format_4)
          id = id_in_tags(words);
        add_element(type, id, words);
      }
    }
  }

  /// Returns the physical id of an element, which is its first tag in format 2; 0 if the element has no tags.
  static long id_in_tags(Tokenizer &words)
  {
    long id = 0;
    const long n_tags = words.whole_number();
    for (long k = 0; k < n_tags; ++k)
    {
      const long tag = words.whole_number();
      id = k == 0 ? std::labs(tag) : id;
    }
    return id;
  }

  unsigned int point_of(long number) const
  {
    const auto found = index.find(number);
    if (found == index.end())
      throw UnreadableMesh("has an element at node " + std::to_string(number) +
                           ", which it does not have; export the mesh anew.");
    return found->second;
  }

  void add_element(const ElementType &type, long id, Tokenizer &words)
  {
    nodes.clear();
    for (unsigned int k = 0; k < type.n_nodes; ++k)
      nodes.push_back(words.whole_number());
    if (type.n_corners == 8)
    {
      content.is_second_order = content.is_second_order || type.n_nodes > type.n_corners;
      content.hexahedra.emplace_back();
      for (unsigned int k = 0; k < 8; ++k)
        content.hexahedra.back()[k] = point_of(nodes[k]);
    }
    else if (type.n_corners == 4 && id != 0)
    {
      if (id > 1000000000)
        throw UnreadableMesh("marks faces with the id " + std::to_string(id) +
                             "; give ids from 1 to 1000000000.");
      MarkedFace &face = content.faces.emplace_back();
      face.id = static_cast<unsigned int>(id);
      for (unsigned int k = 0; k < 4; ++k)
        face.corners[k] = point_of(nodes[k]);
    }
  }

  std::map<std::string, std::string_view> sections;
  bool is_format_4 = false, is_format_4_0 = false;
  std::map<long, long> physical_id;             ///< physical id of each surface, by the surface's number
  std::unordered_map<long, unsigned int> index; ///< index of each point, by the number of its node
  MeshContent content;
  std::vector<long> nodes; ///< nodes of the current element
};

} // namespace

std::string printable(std::string_view text, std::size_t max_length)
{
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string shown;
  for (auto here = text.begin(); here != text.end() && max_length > 0; --max_length)
  {
    const auto start = here;
    const boost::locale::utf::code_point letter = Utf8::decode(here, text.end());
    const bool is_control = letter < 0x20 || (letter >= 0x7f && letter < 0xa0);
    if (boost::locale::utf::is_valid_codepoint(letter) && !is_control)
      shown.append(start, here);
    else
      shown += '?';
  }
  return shown;
}

MeshContent read_gmsh(const std::string &text)
{
  return GmshReader(text).read();
}

} // namespace stemware::fem
