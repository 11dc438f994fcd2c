#include "fem/pipeline/study/profile_file.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/column_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

std::string entry_of(const std::string &file)
{
  return "Glass/Profile file = " + shortened_path(file);
}

/// Returns the points of a section [m]. Throws BadInput for coordinates of 1 m or more, probably given in mm.
std::vector<fem::SectionVertex> points_in(const std::string &file)
{
  std::vector<fem::SectionVertex> points;
  for (const auto &row : parse_columns(entry_of(file), read_input_text(entry_of(file), file),
                                       { { { "r", "radius" }, "m" }, { { "z", "height" }, "m" } }))
  {
    const double r = row.cells[0], z = row.cells[1];
    ensure(std::abs(r) < 1 && std::abs(z) < 1,
           fmt::format(FMT_STRING("{}, line {}: r = {} m, z = {} m is larger than any glass; these look like "
                                  "millimetres: write \"r (mm), z (mm)\" as the first line."),
                       entry_of(file), row.line, to_short_text(r), to_short_text(z)));
    points.push_back({ r, z, row.line });
  }
  return points;
}

/// Returns the mean of the radii of the first and the last of the lowest points.
double lowest_radius(const std::vector<fem::SectionVertex> &points)
{
  const auto is_lower = [](const auto &a, const auto &b) { return a.height < b.height; };
  return (std::min_element(points.begin(), points.end(), is_lower)->radius +
          std::min_element(points.rbegin(), points.rend(), is_lower)->radius) /
         2;
}

void fit_rim(const std::vector<fem::SectionVertex> &points, Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  const auto circle = fem::fit_rim_circle(points, profile.land_width);
  const auto is_given = [&](const char *entry, double value, const double fem::RimCircle::*fitted)
  {
    const bool is_fitted = circle && std::abs(value - (*circle).*fitted) <= 1e-12 * std::abs(value);
    return study.given_entries.count(entry) > 0 && !is_fitted;
  };
  const bool has_radius =
    is_given("Glass/Contact radius", profile.contact_radius, &fem::RimCircle::contact_radius);
  const bool has_crown = is_given("Glass/Crown radius", profile.crown_radius, &fem::RimCircle::crown_radius);
  ensure(circle || has_crown,
         entry_of(study.glass.profile_file) +
           ": no circle fits the points within half of Glass/Land width = " + to_text(profile.land_width) +
           " m of the lowest one; draw at least three points of the rounded rim "
           "there, or give Glass/Crown radius (0 for a flat land).");
  if (!has_radius)
    profile.contact_radius = circle ? circle->contact_radius : lowest_radius(points);
  if (!has_crown)
    profile.crown_radius = circle->crown_radius;
  if (!has_radius || !has_crown)
    study.glass.rim_circle = circle;
}

} // namespace

void attach_profile(Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  profile.section.reset();
  study.glass.rim_circle.reset();
  if (profile.shape != fem::GlassShape::profile)
    return;
  const std::string &file = study.glass.profile_file;
  ensure(!file.empty(), "Glass/Shape = profile needs Glass/Profile file; name a file with the points (r, z) "
                        "of the foot's section.");
  const std::vector<fem::SectionVertex> points = points_in(file);
  try
  {
    profile.section = std::make_shared<fem::MeridianSection>(points);
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(entry_of(file) + ": " + error.what());
  }
  study.glass.n_profile_points = static_cast<unsigned int>(points.size());
  fit_rim(points, study);
}

std::string profile_note(const GlassSection &glass)
{
  if (!glass.profile.section)
    return "";
  const std::string note =
    fmt::format(FMT_STRING("{} points; contact radius {:.6g} m, crown radius {:.6g} m"),
                glass.n_profile_points, glass.profile.contact_radius, glass.profile.crown_radius);
  const fem::RimCircle circle = glass.rim_circle.value_or(fem::RimCircle());
  return circle.n_points == 0
           ? note
           : note + fmt::format(FMT_STRING(", from a circle through {} points of the land ({:.2g} µm rms)"),
                                circle.n_points, 1e6 * circle.rms_distance);
}

} // namespace stemware::pipeline
