#pragma once

#include "fem/contact/footprint.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/geometry/rim_circle.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/report/plot.h"
#include "ring_model/motion.h"

#include <vector>

/// The plots of the foot itself, and of its mesh.
namespace stemware::pipeline
{

/// Lengths in the pictures of a foot, beside its cells [m].
struct FootLengths
{
  double contact_radius = 0;
  double crown_radius = 0;      ///< 0: flat, or not known
  double load_inner_radius = 0; ///< between which the foot carries load
  double load_outer_radius = 0;
  double outer_radius = 0;     ///< of the foot
  double height = 0;           ///< of the stem's cut
  double stem_radius = 0;      ///< of the glass at the stem's cut
  double thickness_at_rim = 0; ///< of the glass above the contact radius
};

/// Outer radius, height and thickness of a foot from the @p cells of its section, of which there must be one.
FootLengths measured(const std::vector<fem::SectionPolygon> &cells, double contact_radius);

/// The section of a foot with its cells and lengths.
Plot section_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths);

/// The cells of section_plot() at the rim above the table, lifted by the crown, and where the foot carries
/// load.
Plot rim_plot(const FootLengths &lengths);

/// p(r, theta) as colours along and across the rim; @p contact_radius [m] is where r - R is zero. The
/// footprint must have a point under pressure. The scale ends at @p largest [Pa]; 0: at its own largest.
Plot footprint_plot(const fem::PressureMap &footprint, double contact_radius, double largest = 0);

/// The section of a loaded foot with its stresses, its displacements drawn larger.
Plot section_stress_plot(const std::vector<fem::StressedPatch> &section);

/// The pressure of footprint_plot() seen from above, through the glass, its distance from the rim drawn
/// larger, with the direction of travel and the side of the orbit's centre. The footprint must have a point
/// under pressure.
Plot view_from_above_plot(const fem::PressureMap &footprint, const FootLengths &lengths,
                          const ring::Motion &motion);

/// The points of the land and the circle through them, heights drawn larger.
Plot rim_circle_plot(const fem::RimCircle &circle);

/// The distances of the points from the circle, between lines at one scatter.
Plot rim_residual_plot(const fem::RimCircle &circle);

/// The faces of a mesh's contact zone, seen from above.
Plot contact_zone_plot(const std::vector<fem::Quadrilateral> &faces);

/// How many cells of a mesh have which scaled Jacobian.
Plot quality_plot(const std::vector<double> &jacobians);

} // namespace stemware::pipeline
