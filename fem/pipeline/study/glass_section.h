#pragma once

#include "fem/geometry/elastic_material.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/rim_circle.h"
#include "fem/pipeline/study/entry_facts.h"
#include "fem/pipeline/study/quantity_text.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Subsection Glass: shape and material of the foot, by default the foot of a wine glass.
struct GlassSection
{
  GlassSection() { profile.shape = fem::GlassShape::foot; }

  fem::GlassProfile profile;
  std::string profile_file;          ///< points of the section, for the shape profile
  unsigned int n_profile_points = 0; ///< points in profile_file
  /// Circle fitted to the points of the land, if it gives contact or crown radius.
  std::optional<fem::RimCircle> rim_circle = {};
  fem::ElasticMaterial material;
  Waviness waviness; ///< rim height, fixed to the glass: positive where the rim is higher above the table

  /// Declares the entries with their facts. A template, to be compiled in one file only.
  template <typename List>
  void declare(List &list)
  {
    using fem::GlassShape;
    const bool has_contact = list.study.load.is_from_contact();
    const bool is_generated = has_contact && list.study.contact.mesh_file.empty();
    const bool is_foot = is_generated && profile.shape == GlassShape::foot;
    const bool is_drawn = is_generated && profile.shape == GlassShape::profile;
    const bool is_step_or_foot = is_generated && !is_drawn;
    list.enter("Glass", has_contact);
    list.choice(
      "Shape", profile.shape,
      { { "step", GlassShape::step }, { "foot", GlassShape::foot }, { "profile", GlassShape::profile } },
      "Section of the glass near the table. step: a plate on a ring (the land) under a cylinder (the stem); "
      "foot: the foot of a wine glass, concave below, tapering to its edge, rounded into the stem; profile: "
      "the points in Profile file",
      used_if(is_generated));
    list.path(
      "Profile file", profile_file,
      "Points (r, z) of the section's outline for Shape = profile, a CSV file (in m, or with the header \"r "
      "(mm), z (mm)\"): from the axis under the foot along the underside, round the edge, over the top and "
      "up the stem to the axis in its cut. A contact radius or crown radius that the study does not give "
      "follows from the points of the land. A relative path starts at the study file",
      used_if(is_drawn));
    list.number("Contact radius", profile.contact_radius, positive, "m",
                "Radius R of the rim that stands on the table", used_if(true), follows_from_profile,
                plausible(0.005, 0.1, "a liqueur glass to a carafe"));
    list.number("Foot radius", profile.foot_radius, positive, "m", "Outer radius of the foot",
                used_if(is_step_or_foot), times_contact_radius(),
                plausible(0.006, 0.12, "a liqueur glass to a carafe"));
    list.number("Foot thickness", profile.foot_thickness, positive, "m",
                "Thickness of a step above the land, of a foot where its top meets the stem",
                used_if(is_step_or_foot), times_contact_radius(0.01),
                plausible(5e-4, 0.03, "the thinnest blown foot to a pressed base"));
    list.number("Land width", profile.land_width, positive, "m",
                "Width of the zone that may touch the table, half of it on either side of the contact radius",
                used_if(is_generated), times_contact_radius(),
                plausible(1e-4, 0.03, "a ground edge to a broad ring"));
    list.number("Land height", profile.land_height, positive, "m",
                "How far the land stands out below a step, or below the outer edge of a foot",
                used_if(is_step_or_foot), times_contact_radius(),
                plausible(1e-5, 0.02, "a polished to a deep ring"));
    list.number("Crown radius", profile.crown_radius, not_negative, "m",
                "Radius of the rim's rounding, seen in a cut through the axis; 0 means a flat land",
                follows_from_profile,
                plausible(1e-4, 0.2, "a ground edge to a rim that is nearly flat; 0 is a flat land"));
    list.number("Underside rise", profile.underside_rise, not_negative, "m",
                "Height of the underside of a foot on the axis, above the land; without effect on a step",
                used_if(is_foot), plausible(0, 0.03, "flat to a deep kick"));
    list.number("Edge thickness", profile.edge_thickness, positive, "m",
                "Thickness of a foot at its outer edge; without effect on a step", used_if(is_foot),
                times_contact_radius(), plausible(2e-4, 0.02, "the thinnest blown foot to a pressed base"));
    list.number("Fillet radius", profile.fillet_radius, not_negative, "m",
                "Radius of the rounding between the top of a foot and the stem, 0 for a sharp corner; "
                "without effect on a step",
                used_if(is_foot), plausible(0, 0.05, "a sharp corner to a trumpet foot"));
    list.number("Stem radius", profile.stem_radius, positive, "m", "Radius of the stem",
                used_if(is_step_or_foot), times_contact_radius(),
                plausible(0.0015, 0.06, "a drawn stem to the body of a tumbler"));
    list.number("Stem height", profile.stem_height, positive, "m",
                "From the top of the foot, where it meets the stem, to the cut through the stem",
                used_if(is_step_or_foot), times_contact_radius(),
                plausible(5e-4, 0.2, "a cut close to the foot to the longest stem"));
    list.number("Young modulus", material.young_modulus, positive, "Pa", "Young's modulus of the glass",
                plausible(1e9, 2.5e11, "plastic (2 GPa), lead crystal (60), soda lime (70), steel (210)"));
    list.number("Poisson ratio", material.poisson_ratio, poisson_range, "1", "Poisson's ratio of the glass",
                plausible(0, 0.49, "cork (0) to nearly incompressible"));
    list.waviness("Rim waviness", waviness,
                  "How the rim is out of flat: harmonics of its height above the table, fixed to the glass "
                  "and positive where it is higher. At the start azimuth 0 points away from the orbit's "
                  "centre. Body of revolution only");
  }
};

} // namespace stemware::pipeline
