#include "fem/pipeline/output/render/plot_script.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Relative changes below this say nothing.
constexpr double rounding = 1e-12;

std::vector<double> in_milli(const std::vector<double> &values)
{
  std::vector<double> scaled;
  for (const double value : values)
    scaled.push_back(1e3 * value);
  return scaled;
}

} // namespace

ReportFigure torque_figure(const TorqueCurve &curve, const std::vector<TruncationRow> &truncations,
                           const std::string &name)
{
  CurvePlot plot = { name,
                     "Torque of friction against the spin, n harmonics kept; the glass spins up to where it "
                     "vanishes (points).",
                     { "spin ω (rad/s)", false, std::pair(curve.omega.front(), curve.omega.back()) },
                     { "torque τ_z (mN m)" },
                     {},
                     "set xzeroaxis lt 8\n" };
  std::vector<double> torques;
  for (const ring::Wrench &friction : curve.friction)
    torques.push_back(1e3 * friction.torque);
  const unsigned int n_all = truncations.back().harmonics;
  plot.curves.push_back({ truncation_title(n_all, n_all), curve.omega, torques, CurveStyle::line, {}, 1 });
  for (std::size_t i = 0; i < curve.harmonics.size() && curve.harmonics[i] <= 3; ++i)
    plot.curves.push_back({ truncation_title(curve.harmonics[i], n_all),
                            curve.omega,
                            in_milli(curve.truncations[i]),
                            CurveStyle::line,
                            {},
                            static_cast<unsigned int>(i) + 2 });
  for (const TruncationRow &row : truncations)
  {
    const bool all = &row == &truncations.back();
    if (all || row.harmonics <= 3)
      plot.curves.push_back(
        { "", { row.omega_terminal }, { 0 }, CurveStyle::points, {}, all ? 1 : row.harmonics + 1 });
  }
  return curve_figure(plot);
}

ReportFigure spin_up_figure(const std::vector<double> &time, const std::vector<SpinUp> &curves,
                            const std::string &name)
{
  CurvePlot plot = {
    name, "Spin-up of the glass from rest.", { "time (s)" }, { "spin ω (rad/s)" }, {}, "set xzeroaxis lt 8\n"
  };
  for (const SpinUp &curve : curves)
    plot.curves.push_back({ curve.title, time, curve.omega, CurveStyle::line, {}, curve.line_type });
  return curve_figure(plot);
}

ReportFigure truncation_figure(const std::vector<TruncationRow> &truncations)
{
  Curve change = { "terminal spin, relative change", {}, {}, CurveStyle::line_and_points };
  for (const TruncationRow &row : truncations)
    if (row.relative_change && std::abs(*row.relative_change) > rounding)
    {
      change.x.push_back(row.harmonics);
      change.y.push_back(std::abs(*row.relative_change));
    }
  CurvePlot plot = { "truncation",
                     "What leaving out the harmonics beyond some number does to the terminal spin.",
                     { "harmonics kept" },
                     { "|Δω / ω|", true },
                     { change } };
  if (!change.x.empty() && change.x.back() <= 8)
    plot.commands = "set xtics 1\n";
  return curve_figure(plot);
}

} // namespace stemware::pipeline
