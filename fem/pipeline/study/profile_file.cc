#include "fem/pipeline/study/profile_file.h"

#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
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

/// The points of a drawn section in m. Lengths of a foot are below 1.
std::vector<fem::SectionVertex> points_in(const std::string &file)
{
  std::vector<fem::SectionVertex> points;
  for (const FileRow &row : read_column_file(
         entry_of(file), file, { { { "r", "R", "radius" }, "m" }, { { "z", "Z", "height" }, "m" } }))
  {
    const double r = row.values[0], z = row.values[1];
    require(
      std::abs(r) < 1 && std::abs(z) < 1,
      fmt::format(FMT_STRING("{}, line {}: r = {} m, z = {} m is larger than any glass; these look like "
                             "millimetres: write \"r (mm), z (mm)\" as the first line."),
                  entry_of(file), row.line, to_short_text(r), to_short_text(z)));
    points.push_back({ r, z, row.line });
  }
  return points;
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

/// Whether @p value was given and is not that of the points.
bool is_given(const Study &study, const char *entry, double value, const std::optional<double> &fitted)
{
  return study.given_entries.count(entry) > 0 &&
         !(fitted && std::abs(value - *fitted) <= 1e-12 * std::abs(value));
}

void fit_rim(const std::vector<fem::SectionVertex> &points, Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  auto circle = fem::fit_rim_circle(points, profile.land_width);
  const auto fitted = [&](double fem::RimCircle::*radius)
  { return circle ? std::optional((*circle).*radius) : std::nullopt; };
  const bool has_radius =
    is_given(study, contact_radius_entry, profile.contact_radius, fitted(&fem::RimCircle::contact_radius));
  const bool has_crown =
    is_given(study, crown_radius_entry, profile.crown_radius, fitted(&fem::RimCircle::crown_radius));
  require(
    circle || has_crown,
    fmt::format(
      FMT_STRING(
        "{}: no circle fits the points within half of Glass/Land width = {} m of the lowest one; draw at "
        "least three points of the rounded rim there, or give Glass/Crown radius (0 for a flat land)."),
      entry_of(study.glass.profile_file), to_text(profile.land_width)));
  if (!has_radius)
    profile.contact_radius = circle ? circle->contact_radius : lowest_radius(points);
  if (!has_crown)
    profile.crown_radius = circle->crown_radius;
  if (!circle || (has_radius && has_crown))
    return;
  if (has_radius)
    circle->covariance[0] = { 0, 0 }, circle->covariance[1][0] = 0;
  if (has_crown)
    circle->covariance[1] = { 0, 0 }, circle->covariance[0][1] = 0;
  study.glass.rim_circle = std::make_shared<const fem::RimCircle>(*circle);
}

/// "29.76 ± 0.12 mm", "4.4 ± 0.9 mm": the error to two digits, to one where that begins with 4 or more.
std::string millimetres(double value, double error)
{
  const double power = std::floor(std::log10(1e3 * error));
  const int digits = 1e3 * error / std::pow(10, power) < 3.55 ? 2 : 1;
  const int decimals = std::clamp(digits - 1 - static_cast<int>(power), 0, 9);
  return fmt::format(FMT_STRING("{:.{}f} ± {:.{}f} mm"), 1e3 * value, decimals, 1e3 * error, decimals);
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
  require(!file.empty(), "Glass/Shape = profile needs Glass/Profile file; name a file with the points (r, z) "
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

std::string profile_note(const Study &study)
{
  const GlassSection &glass = study.glass;
  if (!glass.profile.section)
    return "";
  const std::string rim = fitted_rim(study);
  std::string note = fmt::format(FMT_STRING("{} points; "), glass.n_profile_points) +
                     (!rim.empty() ? rim
                                   : fmt::format(FMT_STRING("contact radius {:.6g} m, crown radius {:.6g} m"),
                                                 glass.profile.contact_radius, glass.profile.crown_radius));
  if (!glass.rim_circle)
    return note;
  const fem::RimCircle &circle = *glass.rim_circle;
  if (rim.empty())
    note += fmt::format(FMT_STRING(", from a circle through {} points of the land"), circle.points.size());
  if (circle.freedom == 0)
    note += ", which say nothing about their scatter";
  if (circle.n_repeated > 0)
    note += fmt::format(FMT_STRING("; {} that stand twice count once"), circle.n_repeated);
  if (crown_is_open(circle))
    note += "; the crown is not determined: more points, or Glass/Crown radius measured by other means, "
            "would say more";
  return note;
}

std::string fitted_rim(const Study &study)
{
  const GlassSection &glass = study.glass;
  if (!glass.rim_circle || !glass.rim_circle->has_scatter())
    return "";
  const fem::RimCircle &circle = *glass.rim_circle;
  std::string text;
  if (circle.contact_radius_error() > 0)
    text += "R = " + millimetres(circle.contact_radius, circle.contact_radius_error());
  if (circle.crown_radius_error() > 0)
    text +=
      (text.empty() ? "crown " : ", crown ") + millimetres(circle.crown_radius, circle.crown_radius_error());
  return text + fmt::format(FMT_STRING(" (rms {} µm, {} points)"),
                            to_short_text(rounded(1e6 * circle.scatter, 2)), circle.points.size());
}

bool crown_is_open(const fem::RimCircle &circle)
{
  return circle.has_scatter() && circle.crown_radius_error() >= circle.crown_radius / 2;
}

} // namespace stemware::pipeline
