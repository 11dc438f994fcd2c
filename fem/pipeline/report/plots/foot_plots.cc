#include "fem/contact/footprint.h"
#include "fem/pipeline/report/plot.h"
#include "fem/pipeline/report/plots/plots.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using Groups = std::vector<std::vector<std::vector<double>>>; ///< as grouped_data() takes them

constexpr double degree = boost::math::double_constants::degree;
constexpr double millimetres = 1e3, micrometres = 1e6; ///< of a metre

struct PressureUnit
{
  double pascals;
  std::string name;
};

/// The largest number of two easy digits that is not above @p factor: 1, 1.5, 2, ... 9.5, 10, 15 ...
double round_down(double factor)
{
  const double power = std::pow(10, std::floor(std::log10(factor)));
  return std::floor(2 * factor / power) / 2 * power;
}

/// The corners of polygons in mm, the first again at the end.
template <typename Polygon>
Groups outlines(const std::vector<Polygon> &polygons)
{
  Groups closed(polygons.size());
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t i = 0; i <= polygons[p].size(); ++i)
    {
      const auto &corner = polygons[p][i % polygons[p].size()];
      closed[p].push_back({ corner[0] * millimetres, corner[1] * millimetres });
    }
  return closed;
}

/// Largest and mean pressure and the width of the contact, for the caption.
Json measures_of(const fem::PressureMap &footprint, double pascals)
{
  if (!fem::has_cells(footprint))
    return nullptr;
  const fem::FootprintMeasures measures = fem::measures_of(footprint);
  const bool is_even = measures.widest - measures.narrowest < 0.005 * measures.widest;
  return { { "most", measures.largest.pressure / pascals },
           { "azimuth", measures.largest.azimuth / degree },
           { "mean", measures.mean / pascals },
           { "narrowest", is_even ? Json(nullptr) : Json(measures.narrowest * micrometres) },
           { "widest", measures.widest * micrometres },
           { "has_edge", footprint.has_edge } };
}

/// p(r, theta) as colours along and across the rim, on a scale that ends at @p largest [Pa].
void add_footprint(const std::string &name, const std::string &state, const fem::PressureMap &footprint,
                   double contact_radius, double largest, Document &document)
{
  const PressureUnit unit =
    fem::largest_pressure(footprint) < 1e6 ? PressureUnit{ 1e3, "kPa" } : PressureUnit{ 1e6, "MPa" };
  Groups cuts;
  for (const auto &cut : fem::loaded_cuts(footprint))
  {
    cuts.emplace_back();
    for (const fem::PressurePoint &point : cut)
      cuts.back().push_back({ point.azimuth / degree, (point.radius - contact_radius) * micrometres,
                              point.pressure / unit.pascals });
  }
  document.texts["pressure_" + name] =
    grouped_data("Pressure of the foot on the table",
                 { "theta (degrees)", "r - R (µm)", "pressure (" + unit.name + ")" }, cuts);
  document.plots[name] = { { "state", state },
                           { "unit", unit.name },
                           { "largest", largest / unit.pascals },
                           { "is_grid", fem::has_cells(footprint) },
                           { "measures", measures_of(footprint, unit.pascals) } };
}

/// The section of a loaded foot with its stresses, its displacements drawn larger.
void add_stresses(const std::vector<fem::StressedPatch> &section, Document &document)
{
  constexpr double share_of_radius = 0.04;
  double edge = 0, move = 0, stress = 0;
  Groups rows;
  for (const fem::StressedPatch &patch : section)
  {
    for (const auto &row : patch)
    {
      rows.emplace_back();
      for (const fem::StressedPoint &point : row)
      {
        edge = std::max(edge, std::abs(point.x));
        move = std::max(move, std::hypot(point.move_x, point.move_z));
        stress = std::max(stress, point.von_mises);
        rows.back().push_back({ point.x, point.z, point.move_x, point.move_z, point.von_mises });
      }
    }
    rows.emplace_back(); // two empty lines part the cells
  }
  document.texts["section_stress"] = grouped_data(
    "Section of the loaded foot, cell by cell",
    { "x (m)", "z (m)", "displacement along x (m)", "displacement along z (m)", "stress of von Mises (Pa)" },
    rows);
  const double magnification =
    move > 0 ? std::pow(10, std::round(std::log10(share_of_radius * edge / move))) : 1;
  document.plots["section_stress"] = { { "magnification", magnification },
                                       { "move", move },
                                       { "stress", stress } };
}

/// The pressure of "footprint" seen from above, through the glass, its distance from the rim drawn larger.
void add_view_from_above(const fem::PressureMap &footprint, double radius, const ring::Motion &motion,
                         Document &document)
{
  constexpr double share_of_radius = 0.12;
  const fem::ContactWidth band = fem::loaded_band(footprint);
  const double extent = std::max({ radius - band.inner, band.outer - radius, 1e-4 * radius });
  Json &values = document.plots["foot_from_above"];
  values = document.plots["footprint"];
  values["largest"] = fem::largest_pressure(footprint) / (values["unit"] == "kPa" ? 1e3 : 1e6);
  values.update({ { "radius", radius * millimetres },
                  { "edge", document.plots["section"]["edge"] },
                  { "magnification", std::max(1., round_down(share_of_radius * radius / extent)) },
                  { "orbit_radius", motion.orbit_radius * millimetres },
                  { "side", motion.orbit_sense == ring::OrbitSense::counterclockwise ? 1 : -1 } });
}

/// "section": the cells of a foot and its lengths; @p crown_radius [m] 0: flat, or not known. There must be a
/// cell.
void add_section_plot(const std::vector<fem::SectionPolygon> &cells, double contact_radius,
                      double crown_radius, Document &document)
{
  const fem::SectionLengths lengths = fem::lengths_of(cells, contact_radius);
  document.texts["section"] =
    grouped_data("Section of the foot, its cells", { "r (mm)", "z (mm)" }, outlines(cells));
  document.plots["section"] = {
    { "radius", contact_radius * millimetres },       { "edge", lengths.outer_radius * millimetres },
    { "top", lengths.height * millimetres },          { "stem", lengths.stem_radius * millimetres },
    { "thickness", lengths.thickness * millimetres }, { "crown", crown_radius * millimetres }
  };
}

} // namespace

void add_foot_plots(const Study &study, const FootReport &foot, Document &document)
{
  const double radius = study.glass.profile.contact_radius;
  double largest = fem::largest_pressure(foot.footprint);
  if (foot.footprint_at_end)
    largest = std::max(largest, fem::largest_pressure(*foot.footprint_at_end)); // one scale for both
  add_footprint("footprint", "At rest", foot.footprint, radius, largest, document);
  if (foot.footprint_at_end)
    add_footprint("footprint_at_end", "At the terminal spin", *foot.footprint_at_end, radius, largest,
                  document);
  add_stresses(foot.stressed_section, document);
  if (foot.section.empty())
    return;
  const double crown = study.contact.mesh_file.empty() ? study.glass.profile.crown_radius : 0;
  add_section_plot(foot.section, radius, crown, document);
  const fem::ContactWidth band = fem::loaded_band(foot.footprint);
  document.plots["rim"] = { { "radius", radius * millimetres },
                            { "crown", crown > 0 ? Json(crown * millimetres) : Json(nullptr) },
                            { "inner", band.inner * millimetres },
                            { "outer", band.outer * millimetres } };
  add_view_from_above(foot.footprint, radius, study.motion.orbit, document);
}

} // namespace stemware::pipeline
