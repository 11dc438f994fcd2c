#include "fem/pipeline/report/slide_results.h"

#include "fem/pipeline/report/head.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
constexpr double turn = boost::math::double_constants::two_pi;

/// The slide from the push to the stop; x along the initial motion, y to its left.
Json path_rows(const SlideStudy &slide)
{
  Json rows = Json::array();
  for (const SlidePoint &point : slide.points)
    rows.push_back(STEMWARE_JSON(point, state.time, state.x, state.y, state.speed, state.heading, state.yaw,
                                 state.omega, slip_ratio, friction.force_x, friction.force_y, friction.torque,
                                 side_acceleration, moment_ratio, kinetic_energy, state.friction_loss));
  return rows;
}

Findings findings_of(const SlideStudy &slide)
{
  const ring::SlidingState &stop = slide.stop().state, &start = slide.start().state;
  const double eps = slide.final_slip_ratio;
  Json body = { { "kind", to_string(slide.question.body) } };
  body.update(STEMWARE_JSON(slide, inertia.mass, inertia.yaw_inertia, inertia.outer_radius,
                            question.inner_radius, centre_of_mass_height));
  Findings findings;
  Json &summary = findings.summary["slide"];
  summary = { { "body", body },
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
                  { "heading", if_finite(stop.heading) },
                  { "yaw_angle", stop.yaw },
                  { "distance", stop.distance } } },
              { "final_slip_ratio", if_finite(eps) },
              { "final_speed_over_rim_speed", if_finite(1 / eps) },
              { "largest_moment_ratio", slide.largest_moment_ratio() },
              { "formal", slide.is_formal() } };
  summary.update(STEMWARE_JSON(slide, energy_error, load_error, mesh_change));
  findings.key_figures = { { "distance", slide.stop().state.distance },
                           { "time", stop.time },
                           { "drift", stop.y },
                           { "yaw_angle", stop.yaw },
                           { "final_slip_ratio", if_finite(eps) } };
  return findings;
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
  const bool is_glass = slide.question.body == SlidingBodyKind::glass;
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
                     { "has_load_error", slide.load_error > 0 },
                     { "is_annulus", slide.question.inner_radius > 0 },
                     { "own_inertia", !is_glass && !slide.inertia_is_given },
                     { "own_height", !is_glass && !slide.height_is_given },
                     { "friction_coefficient", slide.friction_coefficient },
                     { "gravity", slide.gravity } };
  add_study(study, {}, document);
  document.facts["sliding"] = sliding_facts(slide);
  document.facts["path"] = path_rows(slide);
  document.plots["path"] = path_values(slide);
  return shown(document, "slide");
}

} // namespace stemware::pipeline
