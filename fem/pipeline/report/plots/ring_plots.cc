#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
constexpr double whole_turn = boost::math::double_constants::two_pi;

/// Two blocks: the load over its mean after 1, 2, 3 and all harmonics, and as it is to be drawn, which is
/// closed after a whole turn.
std::string round_the_rim(const ring::RingStack &load, std::vector<fem::AzimuthLoad> pointwise)
{
  constexpr unsigned int n_intervals = 360;
  std::vector<double> theta;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    theta.push_back(whole_turn * i / n_intervals);
  Table truncations = { "Load over its mean, by the harmonics that are kept",
                        { numbers("theta", "rad", theta) } };
  for (const unsigned int order : { 1u, 2u, 3u, load.n_harmonics() })
  {
    const ring::RingStack kept = load.truncated(std::min(order, load.n_harmonics()));
    truncations.columns.push_back(numbers("n up to " + std::to_string(kept.n_harmonics()), "1", theta,
                                          [&](double angle) { return kept(angle) / load.a(0); }));
  }
  const bool is_pointwise = !pointwise.empty();
  if (is_pointwise)
    pointwise.push_back({ pointwise.front().azimuth + whole_turn, pointwise.front().density });
  for (std::size_t i = 0; !is_pointwise && i < theta.size(); ++i)
    pointwise.push_back({ theta[i], load(theta[i]) });
  const auto over_mean = [&](const fem::AzimuthLoad &place) { return place.density / load.a(0); };
  return data_tables({ truncations,
                       { is_pointwise ? "As it was solved" : "All harmonics",
                         { numbers("theta", "rad", pointwise, &fem::AzimuthLoad::azimuth),
                           numbers("lambda / a_0", "1", pointwise, over_mean) } } });
}

/// A harmonic of a load.
struct Harmonic
{
  unsigned int n;
  double amplitude; ///< over the mean
  double band;      ///< half-width of its error, 0: not known
  bool is_resolved;
};

} // namespace

void add_load_plots(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
                    const std::vector<double> &band, ring::OrbitSense sense, Document &document)
{
  document.texts["round_the_rim"] = round_the_rim(load, pointwise);
  const double turn = std::abs(load.b(1)) > 1e-9 * load.a(0) ? std::copysign(1., load.b(1)) : 0;
  document.facts["rim_load"] = { { "side", sense == ring::OrbitSense::counterclockwise ? 1 : -1 },
                                 { "turn", turn },
                                 { "mean", load.a(0) / load.radius() },
                                 { "n_all", load.n_harmonics() },
                                 { "is_pointwise", !pointwise.empty() },
                                 { "a_1", load.a(1) / load.a(0) },
                                 { "b_1", load.b(1) / load.a(0) } };

  // Harmonics without a band of their own are judged by the last one that has some.
  const auto last_banded = std::find_if(band.rbegin(), band.rend(), [](double width) { return width > 0; });
  std::vector<Harmonic> harmonics;
  for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
  {
    const double amplitude = std::hypot(load.a(n), load.b(n)) / load.a(0),
                 own = band.empty() ? 0 : band.at(n);
    const double judge = own > 0 || last_banded == band.rend() ? own : *last_banded;
    harmonics.push_back({ n, amplitude, own, amplitude > judge });
  }
  document.tables["spectrum"] = { "Harmonics of the load",
                                  { numbers("n", "1", harmonics, &Harmonic::n),
                                    numbers("amplitude over the mean", "1", harmonics, &Harmonic::amplitude),
                                    numbers("half-width of its error band, 0: none", "1", harmonics,
                                            &Harmonic::band),
                                    numbers("resolved", "1", harmonics, &Harmonic::is_resolved) } };
  const bool has_hollow =
    std::any_of(harmonics.begin(), harmonics.end(),
                [](const Harmonic &each) { return !each.is_resolved && each.amplitude > 1e-12; });
  document.plots["spectrum"] = { { "has_hollow", has_hollow } };
}

void add_slip_plot(const ring::Motion &motion, double radius, const std::vector<SlidingState> &states,
                   Document &document)
{
  std::vector<std::string> titles;
  std::vector<Table> blocks;
  for (const SlidingState &state : states)
  {
    const std::vector<RimSlip> places = rim_slip(motion, radius, state.load, state.omega);
    titles.push_back(state.title);
    blocks.push_back(
      { state.title,
        { numbers("theta", "rad", places, &RimSlip::azimuth),
          numbers("slip along v, over v", "1", places, &RimSlip::slip_x),
          numbers("slip to the left, over v", "1", places, &RimSlip::slip_y),
          numbers("friction along v, over that of the mean load", "1", places, &RimSlip::friction_x),
          numbers("friction to the left", "1", places, &RimSlip::friction_y) } });
  }
  document.texts["slip"] = data_tables(blocks);
  document.plots["slip"] = { { "title", titles } };
}

void add_torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows, Document &document)
{
  Json harmonics = Json::array(), terminal = Json::array(), line_types = Json::array();
  std::copy_if(curve.harmonics.begin(), curve.harmonics.end(), std::back_inserter(harmonics),
               [](unsigned int n) { return n <= 3; });
  for (const SpinRow &row : rows)
    if (const bool all = &row == &rows.back(); row.omega_terminal() && (all || row.harmonics <= 3))
    {
      terminal.push_back(*row.omega_terminal());
      line_types.push_back(all ? 1 : row.harmonics + 1);
    }
  const std::optional<double> spin_unit = curve.spin_unit();
  document.plots["torque"] = { { "n_all", rows.back().harmonics },
                               { "harmonics", harmonics },
                               { "terminal", terminal },
                               { "terminal_type", line_types },
                               { "spin_unit", spin_unit ? Json(*spin_unit) : Json(nullptr) } };
}

void add_spin_up_plot(const std::vector<double> &time, const std::vector<SpinCurve> &curves,
                      const SpinRow &all, const std::vector<MeasuredSpin> &measured,
                      const std::string &opening, Document &document)
{
  Table table = { "Spin-up from rest", { numbers("time", "s", time) } };
  Json titles = Json::array(), line_types = Json::array(), times = Json::array(), spins = Json::array();
  for (const SpinCurve &curve : curves)
  {
    table.columns.push_back(numbers("omega, " + curve.title, "rad/s", curve.omega));
    titles.push_back(curve.title);
    line_types.push_back(curve.line_type);
  }
  for (const MeasuredSpin &point : measured)
  {
    times.push_back(point.time);
    spins.push_back(point.omega);
  }
  const double time_constant = all.time_constant().value_or(0);
  document.tables["spin_up_curves"] = table;
  document.plots["spin_up"] = { { "opening", opening },
                                { "curve", titles },
                                { "line_type", line_types },
                                { "terminal", all.omega_terminal().value_or(std::nan("")) },
                                { "measured_time", times },
                                { "measured_omega", spins },
                                { "has_measured", !measured.empty() },
                                { "time_constant", time_constant },
                                { "has_time_constant", all.omega_terminal() && time_constant > 0 &&
                                                         time_constant < time.back() } };
}

} // namespace stemware::pipeline
