#include "fem/pipeline/result/foot_pictures.h"

#include "fem/contact/footprint.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/result/pictures.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double millimetres = 1e3, micrometres = 1e6; ///< per metre

/// Returns the largest of the numbers 1, 1.5, 2, ... 9.5, 10, 15 ... that does not exceed @p factor.
double round_down(double factor)
{
  const double power = std::pow(10, std::floor(std::log10(factor)));
  return std::floor(2 * factor / power) / 2 * power;
}

/// Returns a length for a drawing of the whole foot, rounded to hundredths of a millimetre (less than a
/// pixel).
Json drawn(double length)
{
  return rounded_number(std::round(1e2 * length * millimetres) / 1e2);
}

/// Returns the quadrilaterals of a loaded section with magnified displacements, and their von Mises stresses
/// [MPa].
Json stresses(const std::vector<fem::StressedPatch> &section)
{
  constexpr double share_of_radius = 0.04;
  double edge = 0, move = 0, stress = 0;
  for (const fem::StressedPatch &patch : section)
    for (const auto &row : patch)
      for (const fem::StressedPoint &point : row)
      {
        edge = std::max(edge, std::abs(point.x));
        move = std::max(move, std::hypot(point.displacement_x, point.displacement_z));
        stress = std::max(stress, point.von_mises);
      }
  const double magnification =
    move > 0 ? std::pow(10, std::round(std::log10(share_of_radius * edge / move))) : 1;
  Json x = Json::array(), z = Json::array(), values = Json::array();
  for (const fem::StressedPatch &patch : section)
    for (std::size_t i = 0; i + 1 < patch.size(); ++i)
      for (std::size_t j = 0; j + 1 < patch[i].size(); ++j)
      {
        const fem::StressedPoint *corners[] = { &patch[i][j], &patch[i][j + 1], &patch[i + 1][j + 1],
                                                &patch[i + 1][j] };
        double mean = 0;
        for (const fem::StressedPoint *corner : corners)
        {
          x.push_back(drawn(corner->x + magnification * corner->displacement_x));
          z.push_back(drawn(corner->z + magnification * corner->displacement_z));
          mean += corner->von_mises / 4;
        }
        values.push_back(rounded_number(mean * 1e-6, 3));
      }
  return { { "x", x },
           { "z", z },
           { "stress", values },
           { "largest", rounded_number(stress * 1e-6) },
           { "magnification", magnification },
           { "move", move * micrometres } };
}

/// Returns the cells of a section and its lengths [mm]. @p crown_radius [m] is 0 if the land is flat or its
/// crown is unknown.
Json section_of(const std::vector<fem::SectionPolygon> &cells, double contact_radius, double crown_radius,
                const fem::ContactWidth &band)
{
  const fem::SectionLengths lengths = fem::lengths_of(cells, contact_radius);
  Json x = Json::array(), z = Json::array();
  for (const fem::SectionPolygon &cell : cells)
  {
    std::vector<double> radii, heights;
    for (const auto &corner : cell)
    {
      radii.push_back(corner[0] * millimetres);
      heights.push_back(corner[1] * millimetres);
    }
    x.push_back(rounded_number(radii, 5));
    z.push_back(rounded_number(heights, 4));
  }
  return { { "x", x },
           { "z", z },
           { "radius", contact_radius * millimetres },
           { "edge", lengths.outer_radius * millimetres },
           { "top", lengths.height * millimetres },
           { "stem", lengths.stem_radius * millimetres },
           { "thickness", lengths.thickness * millimetres },
           { "crown", crown_radius * millimetres },
           { "inner", band.inner * millimetres },
           { "outer", band.outer * millimetres } };
}

} // namespace

void add_foot_pictures(const Study &study, const FootReport &foot, const ErrorBands &bands, Results &results)
{
  constexpr double share_of_radius = 0.12;
  const double radius = study.glass.profile.contact_radius;
  Json &pictures = results.tables["foot"];
  double largest = fem::largest_pressure(foot.footprint);
  if (foot.footprint_at_end)
    // Both footprints have one scale.
    largest = std::max(largest, fem::largest_pressure(*foot.footprint_at_end));
  const std::optional<double> band = band_of(bands, "peak_pressure");
  pictures["footprint"] =
    pressure_map(foot.footprint, radius, largest, foot.at_rest.load.peak_pressure, band);
  if (foot.footprint_at_end)
    pictures["footprint_at_end"] =
      pressure_map(*foot.footprint_at_end, radius, largest, foot.at_end->load.peak_pressure, band);
  if (!foot.stressed_section.empty())
    pictures["stresses"] = stresses(foot.stressed_section);
  if (foot.section.empty())
    return;
  const double crown = study.contact.mesh_file.empty() ? study.glass.profile.crown_radius : 0;
  const fem::ContactWidth zone = fem::loaded_band(foot.footprint);
  pictures["section"] = section_of(foot.section, radius, crown, zone);
  // Footprint seen from above. Its distance from the rim is magnified.
  const double extent = std::max({ radius - zone.inner, zone.outer - radius, 1e-4 * radius });
  pictures["magnification"] = std::max(1., round_down(share_of_radius * radius / extent));
}

} // namespace stemware::pipeline
