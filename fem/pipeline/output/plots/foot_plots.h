#pragma once

#include "fem/contact/pressure_map.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/output/render/report.h"
#include "ring_model/motion.h"

#include <utility>
#include <vector>

/// The plots of the foot itself.
namespace stemware::pipeline
{

/// What the pictures of a foot show beside its cells, lengths in m.
struct FootLengths
{
  double contact_radius = 0;
  double crown_radius = 0;      ///< 0: flat, or not known
  double load_inner_radius = 0; ///< between which the foot carries load
  double load_outer_radius = 0;
  double outer_radius = 0;     ///< of the foot
  double height = 0;           ///< of the stem's cut
  double thickness_at_rim = 0; ///< of the glass above the contact radius
};

/// Outer radius, height and thickness of a foot from the @p cells of its section, of which there must be one.
FootLengths measured(const std::vector<fem::SectionPolygon> &cells, double contact_radius);

/// Least and largest radius in contact at any azimuth, as fem::contact_width() [m]; of points that are no
/// grid those under pressure. The footprint must have a point under pressure.
std::pair<double, double> loaded_band(const fem::PressureMap &footprint);

/// Whether a footprint is a grid with several points across the contact.
bool has_cells(const fem::PressureMap &footprint);

/// The largest pressure [Pa].
double largest_pressure(const fem::PressureMap &footprint);

/// The cuts that a picture shows: of a footprint with cells every so many, the first one again after a whole
/// turn, each at equally many places between the edges of its pressure, which lie between the points of the
/// grid, and not a number where it has no load; of others the points under pressure.
std::vector<std::vector<fem::PressurePoint>> drawn_cuts(const fem::PressureMap &footprint);

/// The section of a foot with its cells and lengths.
Plot section_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths);

/// The cells at the rim above the table, lifted by the crown, and where the foot carries load.
Plot rim_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths);

/// The pressure seen from below, its distance from the rim drawn larger, with the direction of travel and the
/// side of the orbit's centre. The footprint must have a point under pressure.
Plot view_from_below_plot(const fem::PressureMap &footprint, const FootLengths &lengths,
                          const ring::Motion &motion);

} // namespace stemware::pipeline
