#include "fem/pipeline/report/slide_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
constexpr double turn = boost::math::double_constants::two_pi;

/// Values of a function at the points of a slide.
template <typename Value>
std::vector<double> of_points(const SlideStudy &slide, const Value &value)
{
  std::vector<double> values;
  for (const SlidePoint &point : slide.points)
    values.push_back(value(point));
  return values;
}

template <typename Value>
Column point_column(const std::string &name, const std::string &unit, const SlideStudy &slide,
                    const Value &value)
{
  return numbers(name, unit, of_points(slide, value));
}

Table path_table(const SlideStudy &slide)
{
  using Point = const SlidePoint &;
  return { "The slide from the push to the stop; x along the initial motion, y to its left",
           { point_column("time", "s", slide, [](Point p) { return p.state.time; }),
             point_column("x", "m", slide, [](Point p) { return p.state.x; }),
             point_column("y", "m", slide, [](Point p) { return p.state.y; }),
             point_column("speed", "m/s", slide, [](Point p) { return p.state.speed; }),
             point_column("heading", "rad", slide, [](Point p) { return p.state.heading; }),
             point_column("yaw angle", "rad", slide, [](Point p) { return p.state.yaw; }),
             point_column("spin", "rad/s", slide, [](Point p) { return p.state.omega; }),
             point_column("slip ratio omega R / v", "1", slide, [](Point p) { return p.slip_ratio; }),
             point_column("T_x along the motion", "N", slide, [](Point p) { return p.friction.force_x; }),
             point_column("T_y to its left", "N", slide, [](Point p) { return p.friction.force_y; }),
             point_column("tau_z", "N m", slide, [](Point p) { return p.friction.torque; }),
             point_column("acceleration to the left", "m/s^2", slide,
                          [](Point p) { return p.side_acceleration; }),
             point_column("moment ratio", "1", slide, [](Point p) { return p.moment_ratio; }),
             point_column("kinetic energy", "J", slide, [](Point p) { return p.kinetic_energy; }),
             point_column("friction loss", "J", slide, [](Point p) { return p.state.friction_loss; }) } };
}

/// A number that may not exist: null where it is not finite.
Json finite_or_null(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Findings findings_of(const SlideStudy &slide)
{
  const ring::SlidingState &stop = slide.stop().state, &start = slide.start().state;
  const double eps = slide.final_slip_ratio;
  const Json inverse = eps == 0 ? Json(nullptr) : Json(1 / eps);
  Findings findings;
  findings.summary["slide"] = { { "body",
                                  { { "kind", to_string(slide.question.body) },
                                    { "mass", slide.inertia.mass },
                                    { "yaw_inertia", slide.inertia.yaw_inertia },
                                    { "outer_radius", slide.inertia.outer_radius },
                                    { "inner_radius", slide.question.inner_radius },
                                    { "centre_of_mass_height", slide.centre_of_mass_height } } },
                                { "start",
                                  { { "speed", start.speed },
                                    { "spin", start.omega },
                                    { "slip_ratio", slide.start().slip_ratio },
                                    { "acceleration_to_the_left", slide.start().side_acceleration },
                                    { "kinetic_energy", slide.start().kinetic_energy } } },
                                { "stop",
                                  { { "time", stop.time },
                                    { "x", stop.x },
                                    { "y", stop.y },
                                    { "heading", finite_or_null(stop.heading) },
                                    { "yaw_angle", stop.yaw },
                                    { "distance", slide.stop().state.distance } } },
                                { "final_slip_ratio", finite_or_null(eps) },
                                { "final_speed_over_rim_speed", inverse },
                                { "largest_moment_ratio", slide.largest_moment_ratio() },
                                { "formal", slide.is_formal() },
                                { "energy_error", slide.energy_error },
                                { "load_error", slide.load_error },
                                { "mesh_change", json_number(slide.mesh_change) } };
  findings.key_figures = { { "distance", slide.stop().state.distance },
                           { "time", stop.time },
                           { "drift", stop.y },
                           { "yaw_angle", stop.yaw },
                           { "final_slip_ratio", finite_or_null(eps) } };
  return findings;
}

Table body_table(const SlideStudy &slide)
{
  const auto row =
    [](const std::string &what, double value, const std::string &unit, const std::string &whence)
  {
    return std::vector<std::string>{ what, format::significant<6>(value) + (unit.empty() ? "" : " " + unit),
                                     whence };
  };
  const bool is_glass = slide.question.body == SlidingBodyKind::glass;
  std::vector<std::vector<std::string>> rows = {
    row("mass", slide.inertia.mass, "kg", "Motion/Mass"),
    row("yaw inertia", slide.inertia.yaw_inertia, "kg m²",
        is_glass || slide.inertia_is_given ? "Motion/Yaw inertia" : "of mass spread like the pressure"),
    row("outer radius R", slide.inertia.outer_radius, "m", "Glass/Contact radius")
  };
  if (slide.question.inner_radius > 0)
    rows.push_back(row("inner radius", slide.question.inner_radius, "m", "--inner-radius"));
  rows.push_back(row("centre of mass above the table", slide.centre_of_mass_height, "m",
                     is_glass || slide.height_is_given ? "Motion/Centre of mass height"
                                                       : "none given: no tilt of the pressure"));
  rows.push_back(row("friction coefficient", slide.friction_coefficient, "", "Motion/Friction coefficient"));
  rows.push_back(row("gravity", slide.gravity, "m/s²", "Motion/Gravity"));
  return words("What slides", { "", "", "from" }, rows);
}

/// Whether the path bends by more than rounding.
bool drifts(const SlideStudy &slide)
{
  return std::abs(slide.stop().state.y) > 1e-9 * slide.stop().state.distance;
}

/// The body on its path, in points of a page 540 wide, at equal steps in time; y there points down.
Json sliding_facts(const SlideStudy &slide)
{
  constexpr double width = 540, rest = 1.5; // seconds at the stop, before it is pushed again
  constexpr unsigned int n_frames = 60;
  const double radius = slide.inertia.outer_radius, end = slide.stop().state.time;
  double least_y = 0, most_y = 0, most_x = 0;
  for (const SlidePoint &point : slide.points)
  {
    least_y = std::min(least_y, point.state.y);
    most_y = std::max(most_y, point.state.y);
    most_x = std::max(most_x, point.state.x);
  }
  const double scale = (width - 20) / (most_x + 2 * radius);
  const auto x = [=](double metres) { return 10 + scale * (metres + radius); };
  const auto y = [=](double metres) { return 10 + scale * (most_y + radius - metres); };
  Json facts = { { "height", 2 * 10 + scale * (most_y - least_y + 2 * radius) + 24 },
                 { "rim", scale * radius },
                 { "dot", std::max(3., 0.14 * scale * radius) },
                 { "seconds", end + rest },
                 { "real_seconds", end },
                 { "frames", Json::array() } };
  std::string path;
  std::size_t i = 0;
  for (unsigned int frame = 0; frame <= n_frames; ++frame)
  {
    const double time = end * frame / n_frames;
    while (i + 2 < slide.points.size() && slide.points[i + 1].state.time < time)
      ++i;
    const ring::SlidingState &a = slide.points[i].state, &b = slide.points[i + 1].state;
    const double t = b.time > a.time ? std::clamp((time - a.time) / (b.time - a.time), 0., 1.) : 1;
    const auto between = [=](double from, double to) { return from + t * (to - from); };
    const double at_x = x(between(a.x, b.x)), at_y = y(between(a.y, b.y));
    facts["frames"].push_back({ { "percent", 100 * time / (end + rest) },
                                { "x", at_x },
                                { "y", at_y },
                                { "turn", -between(a.yaw, b.yaw) * 360 / turn } });
    path += fmt::format(FMT_STRING("{}{:.1f},{:.1f}"), frame == 0 ? "M" : " L", at_x, at_y);
  }
  facts["path"] = path;
  facts["start"] = facts["frames"].front();
  facts["stop"] = facts["frames"].back();
  return facts;
}

/// Values of "path": the body's outline and a mark on it at equal distances.
Json path_values(const SlideStudy &slide)
{
  constexpr unsigned int n_outlines = 6;
  std::vector<double> x, y, yaw;
  for (const SlidePoint &point : slide.points)
  {
    const ring::SlidingState &state = point.state;
    const double share = static_cast<double>(x.size()) / (n_outlines - 1);
    if (state.distance < slide.stop().state.distance * share * (1 - 1e-9))
      continue;
    x.push_back(state.x);
    y.push_back(state.y);
    yaw.push_back(state.yaw);
  }
  // As high as the path is wide needs it, beside what axes and their names take.
  const auto [lowest, highest] = std::minmax_element(y.begin(), y.end());
  const auto [first, last] = std::minmax_element(x.begin(), x.end());
  const double diameter = 2 * slide.inertia.outer_radius;
  const double height =
    std::clamp(160 + 420 * (*highest - *lowest + diameter) / (*last - *first + diameter), 240., 540.);
  return { { "height", height },
           { "radius", slide.inertia.outer_radius },
           { "x_at", x },
           { "y_at", y },
           { "yaw_at", yaw } };
}

} // namespace

Results tabulate(const Study &study, const SlideStudy &slide)
{
  const ring::SlidingState &stop = slide.stop().state;
  const double eps = slide.final_slip_ratio;
  Document document = { findings_of(slide) };
  document.facts = { { "turns", std::abs(stop.yaw) / turn },
                     { "drifts", drifts(slide) },
                     { "is_straight", !drifts(slide) && slide.question.spin != 0 },
                     { "side", stop.y < 0 ? "to the right" : "to the left" },
                     { "beside", std::abs(stop.y) },
                     { "ends_together", eps != 0 && std::isfinite(eps) },
                     { "turns_never", eps == 0 && slide.question.spin == 0 },
                     { "spin_ends_first", eps == 0 && slide.question.spin != 0 },
                     { "sliding_ends_first", !std::isfinite(eps) },
                     { "has_load_error", slide.load_error > 0 } };
  add_head(study, {}, document);
  document.facts["sliding"] = sliding_facts(slide);
  document.tables = { { "path", path_table(slide) }, { "body", body_table(slide) } };
  document.plots["path"] = path_values(slide);
  add_study(study, document);
  return shown(document, "slide");
}

} // namespace stemware::pipeline
