#include "fem/meshing/mesh_content.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace stemware::fem
{

namespace
{

/// Keyword line: "*ELEMENT, TYPE=C3D8, ELSET=EALL" in capital letters, without blanks.
struct Keyword
{
  std::string name;
  std::map<std::string, std::string> values; ///< empty for those without =

  std::string value(const std::string &key) const
  {
    const auto found = values.find(key);
    return found == values.end() ? "" : found->second;
  }
};

/// The parts of a line between its commas, without blanks and quotes, in capital letters as all of Abaqus's
/// names are.
std::vector<std::string> cells_of_abaqus(std::string_view line)
{
  std::vector<std::string> cells(1);
  for (const char letter : line)
    if (letter == ',')
      cells.emplace_back();
    else if (std::string_view(" \t\r\v\f\"").find(letter) == std::string_view::npos)
      cells.back() += letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  return cells;
}

Keyword keyword_of(const std::vector<std::string> &cells)
{
  Keyword keyword;
  keyword.name = cells.front();
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    const std::size_t equal_sign = cells[i].find('=');
    keyword.values[cells[i].substr(0, equal_sign)] =
      equal_sign == std::string::npos ? "" : cells[i].substr(equal_sign + 1);
  }
  return keyword;
}

/// The id that the name of a surface or set ends in; 0 where it ends in none.
unsigned int id_at_end(const std::string &name)
{
  const std::size_t begin = name.find_last_not_of("0123456789") + 1; // 0 where all are digits
  constexpr std::size_t max_digits = 9;                              // longer ones are dates
  const std::string digits = name.substr(begin);
  return digits.empty() || digits.size() > max_digits ? 0 : static_cast<unsigned int>(std::stoul(digits));
}

/// Whether a set is one of Gmsh's elementary surfaces, "Surface70", whose numbers are no ids.
bool is_elementary(const std::string &set)
{
  const std::string gmsh_name = "SURFACE";
  return boost::starts_with(set, gmsh_name) &&
         set.find_first_not_of("0123456789", gmsh_name.size()) == std::string::npos;
}

ElementType type_of(const std::string &name)
{
  struct Family
  {
    const char *beginning;
    ElementType type;
  };
  // "CPS4R" is one of "CPS4".
  static const std::vector<Family> families = {
    { "C3D8", { 8, 8 } },   { "C3D20", { 20, 8 } }, { "C3D27", { 27, 8 } }, { "CPS4", { 4, 4 } },
    { "CPS8", { 8, 4 } },   { "CPE4", { 4, 4 } },   { "CPE8", { 8, 4 } },   { "CAX4", { 4, 4 } },
    { "CAX8", { 8, 4 } },   { "M3D4", { 4, 4 } },   { "M3D8", { 8, 4 } },   { "M3D9", { 9, 4 } },
    { "SFM3D4", { 4, 4 } }, { "SFM3D8", { 8, 4 } }, { "R3D4", { 4, 4 } },   { "S4", { 4, 4 } },
    { "S8R", { 8, 4 } },    { "S9R5", { 9, 4 } }
  };
  // Points, lines and springs, which have no faces.
  static const std::vector<const char *> without_faces = { "MASS", "ROTARYI", "HEATCAP", "SPRING", "DASHPOT",
                                                           "CONN", "DCOUP",   "GAP",     "T2D",    "T3D",
                                                           "B2",   "B3",      "PIPE",    "ELBOW",  "FRAME" };
  for (const Family &family : families)
    if (boost::starts_with(name, family.beginning))
      return family.type;
  for (const char *beginning : without_faces)
    if (boost::starts_with(name, beginning))
      return {};
  throw UnreadableMesh("has elements of the type " + printable(name).substr(0, 20) +
                       "; export hexahedra: C3D8, C3D20 or C3D27.");
}

/// Reads one file, line by line. Element surfaces and sets are looked up when all of it is known.
class AbaqusReader
{
public:
  MeshContent read(std::string_view text)
  {
    std::vector<std::string> open; // a keyword line that ends in a comma goes on in the next
    while (!text.empty())
    {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      std::vector<std::string> cells = cells_of_abaqus(line);
      if (boost::starts_with(cells.front(), "**") || (cells.size() == 1 && cells.front().empty()))
        continue;
      const bool is_keyword = !open.empty() || boost::starts_with(cells.front(), "*");
      open.insert(open.end(), cells.begin(), cells.end());
      if (is_keyword && cells.back().empty())
        continue;
      is_keyword ? take_keyword(keyword_of(open)) : take_row(cells);
      open.clear();
    }
    finish_section();
    if (points.points.empty() || elements.empty())
      throw UnreadableMesh("is not an Abaqus .inp mesh: it has no *NODE or no *ELEMENT; export hexahedra, "
                           "C3D8.");
    for (const auto &[number, element] : elements)
      if (element.type.n_corners == 8)
        add(element, 0, { 0, 1, 2, 3, 4, 5, 6, 7 });
    mark_faces();
    content.points = std::move(points.points);
    content.names.id_instructions =
      "end the names of its sets or surfaces of faces (*SURFACE, TYPE=ELEMENT) in ids";
    return std::move(content);
  }

private:
  /// Entry of a set or surface: elements from first to last in steps, or the name of another set.
  struct Member
  {
    std::string set; ///< empty for elements
    long first = 0, last = 0, step = 1;
  };

  struct Surface
  {
    unsigned int id;
    Member member;
    std::string side; ///< of hexahedra: S1 to S6
  };

  /// Hexahedron, or quadrilateral.
  struct Element
  {
    ElementType type;
    std::vector<long> corners;
  };

  void take_keyword(const Keyword &keyword)
  {
    finish_section();
    section = keyword;
    static const std::set<std::string> makers = { "*NGEN",  "*NFILL",  "*NCOPY", "*NMAP",
                                                  "*ELGEN", "*ELCOPY", "*SYSTEM" };
    if (keyword.name == "*INCLUDE" || (has_rows_of_mesh() && keyword.values.count("INPUT") > 0))
      throw UnreadableMesh("reads another file (" + keyword.name + "); export the mesh as one file.");
    if (makers.count(keyword.name) > 0)
      throw UnreadableMesh("generates nodes or elements by " + keyword.name +
                           "; export each node and element explicitly.");
    const std::string name = keyword.value("NAME");
    if (keyword.name == "*ASSEMBLY" || keyword.name == "*ENDINSTANCE")
      is_of_assembly = true;
    else if (keyword.name == "*INSTANCE" || keyword.name == "*ENDASSEMBLY")
      is_of_assembly = false;
    for (const char *kind : { "*PART", "*INSTANCE" })
      if (std::vector<std::string> &names = names_of[kind]; keyword.name == kind)
      {
        names.push_back(printable(name));
        if (names.size() > 1)
          throw UnreadableMesh("has several of " + keyword.name + " (" + boost::join(names, ", ") +
                               "); export the foot alone, as one part.");
      }
    if (keyword.name == "*NODE" && keyword.values.count("SYSTEM") > 0 && keyword.value("SYSTEM") != "R")
      throw UnreadableMesh("has nodes in the coordinates SYSTEM = " + printable(keyword.value("SYSTEM")) +
                           "; export x, y, z.");
    if (keyword.name == "*ELEMENT")
      type = type_of(keyword.value("TYPE"));
    if (keyword.name != "*SURFACE")
      return;
    const bool has_faces = keyword.values.count("TYPE") == 0 || keyword.value("TYPE") == "ELEMENT";
    surface_id = has_faces ? id_at_end(name) : 0;
    if (surface_id != 0)
      content.names.of_ids[surface_id] = name;
    else if (has_faces)
      content.names.without_ids.push_back(name);
  }

  bool has_rows_of_mesh() const
  {
    return section.name == "*NODE" || section.name == "*ELEMENT" || section.name == "*ELSET" ||
           section.name == "*SURFACE";
  }

  void take_row(std::vector<std::string> cells)
  {
    if (section.name == "*INSTANCE")
      throw UnreadableMesh(
        "displaces an instance of a part (*INSTANCE); export the nodes in global coordinates.");
    if (section.name == "*NODE" && !is_of_assembly) // else a reference point, numbered from 1 again
      take_node(cells);
    else if (section.name == "*ELEMENT" && !is_of_assembly && type.n_corners == 0)
      elements.emplace(count_in(cells, 0), Element());
    else if (section.name == "*ELEMENT" && !is_of_assembly)
      take_nodes_of_element(cells);
    else if (section.name == "*ELSET")
      take_members(cells);
    else if (section.name == "*SURFACE" && surface_id != 0)
      surfaces.push_back({ surface_id, member_of(cells.front()), cells.size() > 1 ? cells[1] : "" });
  }

  [[noreturn]] void refuse_row(const std::vector<std::string> &cells) const
  {
    throw UnreadableMesh("has the row \"" + printable(boost::join(cells, ", ")) + "\" below " +
                         printable(section.name) + ", which cannot be read; export the mesh anew.");
  }

  long count_in(const std::vector<std::string> &cells, std::size_t i) const
  {
    const auto number = i < cells.size() ? whole_number_in(cells[i]) : std::nullopt;
    if (!number || *number < 0)
      refuse_row(cells);
    return *number;
  }

  void take_node(std::vector<std::string> cells)
  {
    std::array<double, 3> x;
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (cells.size() < 4)
        refuse_row(cells);
      std::replace(cells[i + 1].begin(), cells[i + 1].end(), 'D', 'E'); // as Fortran writes an exponent
      const auto coordinate = number_in(cells[i + 1]);
      if (!coordinate)
        refuse_row(cells);
      x[i] = *coordinate;
    }
    points.add(count_in(cells, 0), x);
  }

  /// An element of many nodes goes on in the next row.
  void take_nodes_of_element(std::vector<std::string> cells)
  {
    constexpr std::size_t max_cells = 16;
    const bool goes_on = cells.back().empty() || cells.size() == max_cells;
    if (cells.back().empty())
      cells.pop_back();
    for (std::size_t i = 0; i < cells.size(); ++i)
      row.push_back(count_in(cells, i));
    if (row.size() < 1 + type.n_nodes && goes_on)
      return;
    if (row.size() != 1 + type.n_nodes)
      refuse_element();
    add_element();
    row.clear();
  }

  [[noreturn]] void refuse_element() const
  {
    throw UnreadableMesh("gives element " + std::to_string(row.front()) + " of the type " +
                         printable(section.value("TYPE")) + " " + std::to_string(row.size() - 1) +
                         " nodes instead of " + std::to_string(type.n_nodes) + "; export the mesh anew.");
  }

  void add_element()
  {
    const long number = row.front();
    const Element element = { type, { row.begin() + 1, row.begin() + 1 + type.n_corners } };
    if (!elements.emplace(number, element).second)
      throw UnreadableMesh("has two elements of the number " + std::to_string(number) + "; export one part.");
    if (const std::string set = section.value("ELSET"); !set.empty())
      sets_of_elements[set].push_back({ "", number, number });
  }

  static Member member_of(const std::string &cell)
  {
    const auto number = whole_number_in(cell);
    return number ? Member{ "", *number, *number } : Member{ cell };
  }

  void take_members(const std::vector<std::string> &cells)
  {
    std::vector<Member> &members = sets[section.value("ELSET")];
    if (section.values.count("GENERATE") > 0)
    {
      const Member member = { "", count_in(cells, 0), count_in(cells, 1),
                              cells.size() > 2 && !cells[2].empty() ? count_in(cells, 2) : 1 };
      if (member.step == 0 || member.last < member.first)
        refuse_row(cells);
      members.push_back(member);
      return;
    }
    for (const std::string &cell : cells)
      if (!cell.empty())
        members.push_back(member_of(cell));
  }

  void finish_section()
  {
    if (!row.empty())
      refuse_element();
  }

  /// Visits the elements that @p member of @p set names. Sets may name sets, and the same ones again: what
  /// is visited in all is bounded.
  template <typename Visit>
  void for_each_element(const std::string &set, const Member &member, const Visit &visit,
                        unsigned int depth = 0)
  {
    constexpr unsigned int deepest = 20;
    constexpr std::size_t max_visits_an_element = 100;
    n_visits += 1;
    if (depth > deepest || n_visits > max_visits_an_element * (elements.size() + surfaces.size() + 1000))
      throw UnreadableMesh("has sets that contain each other; export the mesh again.");
    if (member.set.empty())
    {
      if (elements.count(member.first) == 0 || elements.rbegin()->first < member.last)
        throw UnreadableMesh("names elements from " + std::to_string(member.first) + " to " +
                             std::to_string(member.last) + " in " + printable(set) +
                             ", of which it does not have all; export the mesh anew.");
      const auto end = elements.upper_bound(member.last);
      for (auto element = elements.find(member.first); element != end; ++element, ++n_visits)
        if ((element->first - member.first) % member.step == 0)
          visit(element->second);
      return;
    }
    bool is_known = false;
    const std::string plain = member.set.substr(member.set.rfind('.') + 1); // of "INSTANCE.SET"
    for (const auto *known : { &sets, &sets_of_elements })
      if (const auto found = known->count(member.set) > 0 ? known->find(member.set) : known->find(plain);
          found != known->end())
      {
        is_known = true;
        for (const Member &inner : found->second)
          for_each_element(member.set, inner, visit, depth + 1);
      }
    if (!is_known)
      throw UnreadableMesh("names the set " + printable(member.set) + " in " + printable(set) +
                           ", which it does not have; export the mesh anew.");
  }

  /// Element surfaces with ids say which faces are which; where there are none, the sets of surface elements
  /// do: those of *ELSET, or else of *ELEMENT.
  void mark_faces()
  {
    for (const Surface &surface : surfaces)
      for_each_element("the surface of id " + std::to_string(surface.id), surface.member,
                       [&](const Element &element) { mark_face(element, surface); });
    const bool has_faces =
      std::any_of(elements.begin(), elements.end(),
                  [](const auto &element) { return element.second.type.n_corners == 4; });
    for (const auto *known : { &sets, &sets_of_elements })
      if (surfaces.empty() && has_faces && content.faces.empty())
        for (const auto &[name, members] : *known)
          mark_quadrilaterals(name, members);
    if (has_faces && content.faces.empty())
      for (const auto &[name, members] : sets)
        content.names.without_ids.push_back(name);
  }

  void mark_quadrilaterals(const std::string &set, const std::vector<Member> &members)
  {
    const unsigned int id = is_elementary(set) ? 0 : id_at_end(set);
    if (id == 0)
      return;
    content.names.of_ids[id] = set;
    for (const Member &member : members)
      for_each_element(set, member,
                       [&](const Element &element)
                       {
                         if (element.type.n_corners == 4)
                           add(element, id, { 0, 1, 2, 3 });
                       });
  }

  void mark_face(const Element &element, const Surface &surface)
  {
    if (element.type.n_corners == 0)
      return;
    if (element.type.n_corners == 4)
      return add(element, surface.id, { 0, 1, 2, 3 });
    const std::string &side = surface.side;
    if (side.size() != 2 || side[0] != 'S' || side[1] < '1' || side[1] > '6')
      throw UnreadableMesh("has the surface of id " + std::to_string(surface.id) + " on the side \"" +
                           printable(side) + "\" of hexahedra; name one of S1 to S6.");
    const auto &places = faces_of_hexahedron[side[1] - '1'];
    add({ { 4, 4 }, element.corners }, surface.id, { places[0], places[1], places[2], places[3] });
  }

  /// Adds the element whose corners stand at @p places of @p element.
  void add(const Element &element, unsigned int id, const std::vector<unsigned int> &places)
  {
    content.add(element.type, id, [&](unsigned int k) { return points.at(element.corners[places[k]]); });
  }

  Keyword section;
  ElementType type;
  unsigned int surface_id = 0;
  bool is_of_assembly = false; ///< the section is of the assembly itself, and not of a part in it
  std::map<std::string, std::vector<std::string>> names_of; ///< parts and instances, by their keyword
  std::vector<long> row;                                    ///< of an element that is not complete yet
  NumberedPoints points;
  std::map<long, Element> elements;                                  ///< by their numbers
  std::map<std::string, std::vector<Member>> sets, sets_of_elements; ///< of *ELSET; of *ELEMENT
  std::vector<Surface> surfaces;                                     ///< those that have an id
  std::size_t n_visits = 0;
  MeshContent content;
};

} // namespace

MeshContent read_abaqus(const std::string &text)
{
  return AbaqusReader().read(text);
}

} // namespace stemware::fem
