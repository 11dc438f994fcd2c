#include "fem/pipeline/study/profile_file.h"

#include "fem/pipeline/study/column_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

constexpr char contact_radius_entry[] = "Glass/Contact radius", crown_radius_entry[] = "Glass/Crown radius";

std::string entry_of(const std::string &file)
{
  return "Glass/Profile file = " + shortened_path(file);
}

/// Lengths of a foot in m are below 1.
void require_metres(const std::string &file, const std::vector<fem::SectionVertex> &points)
{
  for (const fem::SectionVertex &point : points)
    require(
      std::abs(point.radius) < 1 && std::abs(point.height) < 1,
      fmt::format(FMT_STRING("{}, line {}: r = {} m, z = {} m is larger than any glass; these look like "
                             "millimetres: write \"r (mm), z (mm)\" as the first line."),
                  entry_of(file), point.line, to_short_text(point.radius), to_short_text(point.height)));
}

/// Where a rim that no circle fits is lowest: the middle of what lies as low as its lowest point.
double lowest_radius(const std::vector<fem::SectionVertex> &points)
{
  double lowest = points.front().height, largest = 0;
  for (const fem::SectionVertex &point : points)
  {
    lowest = std::min(lowest, point.height);
    largest = std::max(largest, point.radius);
  }
  double inner = largest, outer = 0;
  for (const fem::SectionVertex &point : points)
    if (point.height <= lowest + 1e-6 * largest)
    {
      inner = std::min(inner, point.radius);
      outer = std::max(outer, point.radius);
    }
  return (inner + outer) / 2;
}

void fit_rim(const std::vector<fem::SectionVertex> &points, Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  const bool has_radius = study.given_entries.count(contact_radius_entry) > 0;
  const bool has_crown = study.given_entries.count(crown_radius_entry) > 0;
  if (has_radius && has_crown)
    return;
  const auto circle = fem::fit_rim_circle(points, profile.land_width);
  require(
    circle || has_crown,
    fmt::format(FMT_STRING("{}: no circle fits the points within half of Glass/Land width = {} m of the "
                           "lowest one; draw at least three points of the rounded rim there, or give "
                           "Glass/Crown radius (0 for a flat land)."),
                entry_of(study.glass.profile_file), to_text(profile.land_width)));
  if (!has_radius)
    profile.contact_radius = circle ? circle->contact_radius : lowest_radius(points);
  if (!has_crown)
    profile.crown_radius = circle->crown_radius;
  study.glass.n_rim_points = circle ? circle->n_points : 0;
}

} // namespace

std::vector<fem::SectionVertex> read_profile_file(const std::string &file)
{
  std::vector<fem::SectionVertex> points;
  for (const FileRow &row : read_column_file(
         entry_of(file), file, { { { "r", "R", "radius" }, "m" }, { { "z", "Z", "height" }, "m" } }))
    points.push_back({ row.values[0], row.values[1], row.line });
  require_metres(file, points);
  return points;
}

bool follows_from_profile(const std::string &path)
{
  return path == contact_radius_entry || path == crown_radius_entry;
}

void attach_profile(Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  profile.section.reset();
  study.glass.n_rim_points = 0;
  if (profile.shape != fem::GlassShape::profile)
    return;
  const std::string &file = study.glass.profile_file;
  require(!file.empty(), "Glass/Shape = profile needs Glass/Profile file; name a file with the points (r, z) "
                         "of the foot's section.");
  const std::vector<fem::SectionVertex> points = read_profile_file(file);
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

std::string profile_note(const Study &study)
{
  const GlassSection &glass = study.glass;
  if (!glass.profile.section)
    return "";
  return fmt::format(
    FMT_STRING("{} points; contact radius {:.6g} m, crown radius {:.6g} m{}"), glass.n_profile_points,
    glass.profile.contact_radius, glass.profile.crown_radius,
    glass.n_rim_points == 0
      ? ""
      : fmt::format(FMT_STRING(", from a circle through {} points of the land"), glass.n_rim_points));
}

} // namespace stemware::pipeline
