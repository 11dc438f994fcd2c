#include "fem/pipeline/output/slide_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/common_sections.h"
#include "fem/pipeline/output/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
constexpr double turn = boost::math::double_constants::two_pi;

/// Of the points of a slide, by a function of each.
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

/// "to the right"; nothing where the path is straight.
std::string side_of(double y)
{
  return y < 0 ? "to the right" : "to the left";
}

/// Whether the path bends by more than rounding.
bool drifts(const SlideStudy &slide)
{
  return std::abs(slide.stop().state.y) > 1e-9 * slide.stop().state.distance;
}

std::string end_sentence(const SlideStudy &slide)
{
  const double eps = slide.final_slip_ratio;
  if (eps == 0)
    return slide.question.spin == 0 ? "It does not turn." : "The spin ends before the sliding.";
  if (!std::isfinite(eps))
    return "The sliding ends before the spin.";
  return fmt::format(FMT_STRING("Speed and spin end at the same instant, with ωR/v = {} (v/ωR = {})."),
                     format::significant<5>(eps), format::significant<5>(1 / eps));
}

std::string formal_sentence(const SlideStudy &slide)
{
  return slide.is_formal()
           ? fmt::format(
               FMT_STRING("Formal: at the moment ratio {} the rear of the linear pressure would have "
                          "to pull on the table; --body glass lifts off instead."),
               format::significant<4>(slide.largest_moment_ratio()))
           : "";
}

constexpr char curl_text[] =
  "Friction acts at the table, below the centre of mass, and presses the front down. On a body that turns "
  "counter-clockwise the front moves to the left, so the friction there points to the right, and at the rear "
  "to the left. The front carries more, so the path bends to the right; a slowly spinning ring is "
  "accelerated sideways by μ² g (h/R) (ωR/v), h the height of its centre of mass. A curling stone that turns "
  "counter-clockwise bends to the left: friction must then be larger at its "
  "rear, which a constant coefficient cannot do; scratches that the front leaves in the ice and the rear "
  "follows are what explains the size.";

std::vector<ResultFile> files_of(const SlideStudy &slide)
{
  return { { "summary.json", "all numbers, for programs" },
           { "parameters.prm", "the study" },
           { "path.dat", "position, motion, friction and energy from the push to the stop",
             path_table(slide) },
           { "timings.json", "how long it took" } };
}

} // namespace

Plot path_plot(const SlideStudy &slide)
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
  return plot_from(
    "path", { { "radius", slide.inertia.outer_radius }, { "x_at", x }, { "y_at", y }, { "yaw_at", yaw } });
}

std::string slide_answer(const SlideStudy &slide)
{
  const ring::SlidingState &stop = slide.stop().state;
  const std::string start = fmt::format(
    FMT_STRING("A {} pushed with {} m/s and spinning at {} rad/s slides {} mm in {} s and makes {} turns."),
    to_string(slide.question.body), format::significant<6>(slide.question.speed),
    format::significant<6>(slide.question.spin), format::significant<4>(1e3 * slide.stop().state.distance),
    format::significant<4>(stop.time), format::significant<4>(std::abs(stop.yaw) / turn));
  const std::string drift =
    drifts(slide) ? fmt::format(FMT_STRING("The spin bends the path {}: it ends {} mm beside the line of the "
                                           "push. A curling stone bends to the other side."),
                                side_of(stop.y), format::significant<4>(1e3 * std::abs(stop.y)))
    : slide.question.spin == 0
      ? ""
      : "Its path is straight: the pressure is not tilted (centre of mass height 0).";
  return joined({ start, drift, end_sentence(slide), formal_sentence(slide) });
}

Results tabulate(const Study &study, const SlideStudy &slide)
{
  Results results;
  results.files = files_of(slide);
  Report &report = results.report;
  report = { fmt::format(FMT_STRING("A {} that slides to rest"), to_string(slide.question.body)),
             slide_answer(slide),
             {} };
  ReportSection path = { "The path", "", { path_plot(slide) } };
  if (drifts(slide))
    path.plots.push_back(plot_from("drift"));
  report.sections.push_back(path);
  if (drifts(slide))
    report.sections.push_back({ "Why it bends that way", curl_text });
  const std::string energy =
    fmt::format(FMT_STRING("Kinetic energy and friction loss add up to that of the push within {} of it."),
                format::scientific_or_zero<1>(slide.energy_error));
  const std::string load =
    slide.load_error > 0
      ? fmt::format(
          FMT_STRING(" Between the slip ratios at which the contact was solved, its load is known to "
                     "{} of its mean."),
          format::scientific_or_zero<1>(slide.load_error))
      : "";
  const std::string mesh =
    slide.mesh_change
      ? fmt::format(
          FMT_STRING(" On contact cells twice as large with half the elastic harmonics its friction at the "
                     "push, half-way and at the stop changes by {} of μN (the torque of μNR) at most: so "
                     "large a share of path, time and final ωR/v is uncertain by the discretisation."),
          format::scientific_or_zero<1>(*slide.mesh_change))
      : "";
  report.sections.push_back(
    { "Speed and spin",
      energy + load + mesh,
      { plot_from("speeds", { { "radius", slide.inertia.outer_radius } }),
        plot_from("slip_ratio", { { "at_stop", slide.final_slip_ratio } }), plot_from("energy") } });
  report.sections.push_back({ "What slides", "", {}, { body_table(slide) } });
  add_closing_sections(report, study, results.files);
  results.console = { { report.answer }, { energy + load + mesh } };
  results.findings = findings_of(slide);
  return results;
}

} // namespace stemware::pipeline
