#include "fem/pipeline/output/plots/budget_plots.h"

#include "fem/pipeline/output/budget_tables.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stemware::pipeline
{

namespace
{

/// One line of the waterfall: a total, or the way from one terminal spin to the next.
struct Bar
{
  std::string title;
  std::optional<double> from, to; ///< [rad/s]; both missing: there is no such model; from missing: a total
  std::optional<double> band;
  bool is_formal = false;

  bool is_faster() const { return std::abs(*to) > std::abs(*from); }
};

/// A number as plots show it, with a true minus.
std::string number_text(const std::string &number)
{
  return boost::replace_all_copy(number, "-", "−");
}

/// The named differences of the chain between its first and its last model; those of harmonics are one.
std::vector<Bar> bars_of(const Budget &budget)
{
  std::vector<Bar> bars;
  if (budget.rows.empty())
    return bars;
  for (const BudgetRow &row : named_steps(budget.rows))
  {
    const auto from = row.difference ? std::optional(*row.omega_terminal - *row.difference) : std::nullopt;
    bars.push_back({ bars.empty() ? "the paper's model" : row.name, bars.empty() ? std::nullopt : from,
                     row.omega_terminal, row.band, row.standing == Standing::formal });
  }
  const BudgetRow &last = budget.rows.back();
  bars.push_back({ "this study", {}, last.omega_terminal, last.band });
  return bars;
}

/// What stands beside a bar: its difference, or a total.
std::string value_text(const Bar &bar, bool is_total, double rounding)
{
  if (!bar.to || (!is_total && !bar.from))
    return "–";
  const double value = is_total ? *bar.to : *bar.to - *bar.from;
  if (std::abs(value) < rounding)
    return "0";
  return number_text(is_total ? format::significant<6>(value) : format::signed_significant<3>(value));
}

constexpr double width = 540; ///< of the plots [points]

/// Names of the rows from above on the vertical axis, and a column of numbers in rad/s to the right of it.
std::string rows_of_names(const std::vector<std::string> &names, const std::vector<std::string> &texts)
{
  constexpr double points_per_character = 7.3;
  std::size_t longest = 0;
  std::string tics, labels;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string place = std::to_string(names.size() - i);
    longest = std::max(longest, width_of(names[i]));
    tics += (i ? ", " : "") + gnuplot_text(names[i]) + " " + place;
    labels += "set label " + std::to_string(i + 1) + " " + gnuplot_text(texts[i]) +
              " at screen 0.97, first " + place + " right font \",14\"\n";
  }
  // Places on the page: terminals differ in the room that they think a text needs.
  const double left = (points_per_character * static_cast<double>(longest) + 15) / width;
  return "set ytics (" + tics + ") scale 0 font \",14\"\nset yrange [0.4:" + std::to_string(names.size()) +
         ".6]\n" + labels + "set lmargin at screen " + to_short_text(std::min(left, 0.5)) +
         "; set rmargin at screen 0.83; set tmargin 5; set bmargin 4\n" +
         "set label 90 \"rad/s\" at screen 0.97, graph 1 right offset 0,0.6 font \",12\" textcolor rgb "
         "\"#555555\"\nunset border; set border 1; set grid x noytics\nset key at screen 0.02, screen 0.985 "
         "left top vertical maxrows 3 samplen 1.6\n";
}

/// Bars of one kind as a block of the data file, with the part of the plot command that draws them.
void add_bars(const std::vector<Bar> &bars, bool faster, bool formal, std::vector<Table> &blocks,
              std::string &drawing)
{
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < bars.size(); ++i)
    if (const Bar &bar = bars[i]; bar.from && bar.to && bar.is_faster() == faster && bar.is_formal == formal)
      rows.push_back({ static_cast<double>(bars.size() - i), *bar.from, *bar.to });
  if (rows.empty())
    return;
  const std::string title = std::string(faster ? "faster" : "slower") + (formal ? ", formally" : "");
  drawing += "data index " + std::to_string(blocks.size()) +
             " using 2:1:2:3:($1 - 0.32):($1 + 0.32) with boxxyerror lt " + (faster ? "1" : "5") +
             (formal ? " dt 1 lw 1 fs pattern 5 border" : " dt 1 lw 1 fs solid 0.85 border") + " title \"" +
             title + "\", \\\n     ";
  blocks.push_back(number_rows(
    title, { { "place from below", "1" }, { "from omega", "rad/s" }, { "to omega", "rad/s" } }, rows));
}

/// Spins that the plot has to show, with some room at both ends.
std::pair<double, double> spin_range(const std::vector<Bar> &bars)
{
  Extent spins;
  for (const Bar &bar : bars)
    if (bar.to)
      for (const double band : { -bar.band.value_or(0), bar.band.value_or(0) })
        spins.include(*bar.to + band);
  if (spins.least > spins.most)
    return { -1, 1 };
  const double span = std::max(spins.most - spins.least, 1e-3 * std::abs(spins.most));
  const double margin = span > 0 ? 0.08 * span : 1;
  return { spins.least - margin, spins.most + margin };
}

/// From each model to the next, drawn between their bars.
Table connectors(const std::vector<Bar> &bars)
{
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i + 1 < bars.size(); ++i)
    if (bars[i].to && bars[i + 1].to)
      rows.push_back({ static_cast<double>(bars.size() - i), *bars[i].to, -1 });
  return number_rows("Lines from one row to the next",
                     { { "place from below", "1" }, { "omega", "rad/s" }, { "step", "1" } }, rows);
}

/// A step of the model, or one thing left out of it.
struct Effect
{
  std::string name;
  std::optional<double> difference; ///< [rad/s]
  std::string reason;               ///< why there is none
  bool is_step;
};

std::vector<Effect> effects_of(const Budget &budget)
{
  std::vector<Effect> effects;
  const std::vector<Bar> bars = bars_of(budget);
  for (std::size_t i = 1; i + 1 < bars.size(); ++i)
    effects.push_back(
      { bars[i].title, bars[i].from && bars[i].to ? std::optional(*bars[i].to - *bars[i].from) : std::nullopt,
        "–", true });
  for (const WithoutRow &row : budget.without)
    effects.push_back(
      { "without " + row.name, row.difference, row.reason == "not defined" ? row.reason : "–", false });
  return effects;
}

/// The decades in which sizes lie, with some room at both ends.
std::pair<double, double> decades_of(Extent sizes)
{
  if (sizes.least > sizes.most)
    return { 0.1, 10 };
  return { std::pow(10, std::floor(std::log10(sizes.least) - 0.2)),
           std::pow(10, std::ceil(std::log10(sizes.most) + 0.2)) };
}

/// Tics of a narrow logarithmic axis, not more than five.
std::string few_decades(double low, double high)
{
  const double n_decades = std::round(std::log10(high / low));
  return n_decades > 4 ? "set xtics 1e" + std::to_string(static_cast<int>(std::ceil(n_decades / 4))) + "\n"
                       : "";
}

} // namespace

Plot waterfall_plot(const Budget &budget, double rounding)
{
  const std::vector<Bar> bars = bars_of(budget);
  std::vector<std::string> names, texts;
  std::vector<std::vector<double>> totals, bands;
  for (std::size_t i = 0; i < bars.size(); ++i)
  {
    const bool is_total = i == 0 || i + 1 == bars.size();
    names.push_back(bars[i].title + (bars[i].is_formal ? " (formal)" : ""));
    texts.push_back(value_text(bars[i], is_total, rounding));
    const auto place = static_cast<double>(bars.size() - i);
    // A model whose forerunner has no spin starts anew.
    if (bars[i].to && (is_total || !bars[i].from))
      totals.push_back({ place, *bars[i].to });
    if (bars[i].to && bars[i].band.value_or(0) > 0)
      bands.push_back({ place, *bars[i].to, *bars[i].band });
  }
  std::vector<Table> blocks;
  std::string drawing = "plot ";
  for (const bool formal : { false, true })
    for (const bool faster : { true, false })
      add_bars(bars, faster, formal, blocks, drawing);
  if (const Table lines = connectors(bars); lines.n_rows() > 0)
  {
    drawing += "data index " + std::to_string(blocks.size()) +
               " using 2:1:(0):3 with vectors nohead lt 8 lw 1 notitle, \\\n     ";
    blocks.push_back(lines);
  }
  if (!bands.empty())
  {
    drawing += "data index " + std::to_string(blocks.size()) +
               " using 2:1:3 with xerrorbars lt 7 lw 1.5 ps 0 title \"error band\", \\\n     ";
    blocks.push_back(number_rows(
      "Error bands",
      { { "place from below", "1" }, { "omega", "rad/s" }, { "half-width of its error band", "rad/s" } },
      bands));
  }
  drawing += totals.empty() ? "NaN notitle\n"
                            : "data index " + std::to_string(blocks.size()) +
                                " using 2:1 with points lt 7 pt 7 ps 1.1 notitle\n";
  if (!totals.empty())
    blocks.push_back(number_rows("Models that no bar leads to",
                                 { { "place from below", "1" }, { "omega", "rad/s" } }, totals));
  const auto [low, high] = spin_range(bars);
  const std::string script = "set xlabel " + gnuplot_text(heading_with_unit(quantity::omega_terminal)) +
                             "\nset xrange [" + to_text(low) + ":" + to_text(high) + "]\n" +
                             tic_commands("x", low, high) + rows_of_names(names, texts) + drawing;
  return { "waterfall",
           "From the paper's terminal spin to that of this study, one step of the model after the other; "
           "the numbers are the differences in rad/s, from top to bottom.",
           script,
           data_tables(blocks),
           width,
           135 + 32. * static_cast<double>(bars.size()) };
}

Plot effects_plot(const Budget &budget, double rounding)
{
  const std::vector<Effect> effects = effects_of(budget);
  std::vector<std::string> names, texts;
  std::vector<std::vector<double>> steps, without;
  Extent sizes;
  for (std::size_t i = 0; i < effects.size(); ++i)
  {
    const Effect &effect = effects[i];
    const bool is_seen = effect.difference && std::abs(*effect.difference) >= rounding;
    names.push_back(effect.name);
    texts.push_back(effect.difference
                      ? number_text(format::signed_significant<3>(is_seen ? *effect.difference : 0))
                      : effect.reason);
    if (!is_seen)
      continue;
    sizes.include(std::abs(*effect.difference));
    (effect.is_step ? steps : without)
      .push_back({ static_cast<double>(effects.size() - i), std::abs(*effect.difference) });
  }
  std::vector<std::vector<double>> edge;
  if (const auto band = budget.rows.back().band; band.value_or(0) > 0)
  {
    sizes.include(*band);
    edge = { { 0.4, *band }, { static_cast<double>(effects.size()) + 0.6, *band } };
  }
  const auto [low, high] = decades_of(sizes);
  std::vector<Table> blocks;
  std::string drawing;
  for (const auto &[title, style, rows] : { std::tuple("steps of the model", "points lt 1 ps 1", &steps),
                                            std::tuple("one thing left out", "points lt 2 ps 1", &without),
                                            std::tuple("error band", "lines lt 8 dt 2", &edge) })
    if (!rows->empty())
    {
      drawing += (drawing.empty() ? "plot data index " : ", \\\n     data index ") +
                 std::to_string(blocks.size()) + " using 2:1 with " + style + " title \"" + title + "\"";
      blocks.push_back(
        number_rows(title, { { "place from below", "1" }, { "size of the difference", "rad/s" } }, *rows));
    }
  return { "effects",
           "How large each effect is: steps from the paper's model to this study's, and what leaving out one "
           "thing of the complete model changes (numbers in rad/s). The error band of the terminal spin "
           "contains none of them.",
           axis_commands("x", { "|difference of terminal spins| (rad/s)", true, { { low, high } } }) +
             few_decades(low, high) + rows_of_names(names, texts) +
             (drawing.empty() ? "plot NaN notitle" : drawing) + "\n",
           data_tables(blocks),
           width,
           135 + 28. * static_cast<double>(effects.size()) };
}

Plot harmonic_torque_plot(const Budget &budget)
{
  std::vector<std::vector<double>> rows;
  Extent torques, differences;
  for (std::size_t i = 0; i < budget.omega.size(); ++i)
  {
    const double all = budget.torque_all[i], first = budget.torque_first[i];
    rows.push_back({ budget.omega[i], all, first, all - first });
    for (const double torque : { all, first })
      torques.include(std::abs(torque));
    differences.include(std::abs(all - first));
  }
  // Differences of rounding would fill the lower panel with noise.
  const bool is_zero = !(differences.most > 1e-9 * torques.most);
  const std::string torque_scale = torques.most >= 1e-4 ? "1e3" : "1e6";
  const std::string scale = differences.most >= 1e-4              ? "1e3"
                            : differences.most >= 1e-7 || is_zero ? "1e6"
                                                                  : "1e9";
  const auto unit = [](const std::string &factor) {
    return factor == "1e3" ? "mN m" : factor == "1e6" ? "µN m" : "nN m";
  };
  const std::string script =
    std::string(
      "set multiplot\nset lmargin at screen 0.16; set rmargin at screen 0.96\nset xzeroaxis lt 8\n") +
    "set tmargin at screen 0.9; set bmargin at screen 0.53\nset format x \"\"\nset ylabel \"τ_z (" +
    unit(torque_scale) + ")\"\nplot data using 1:($2 * " + torque_scale +
    ") with lines lt 1 title \"all harmonics\", \\\n     data using 1:($3 * " + torque_scale +
    ") with lines lt 2 title \"first harmonic\"\n" +
    "set tmargin at screen 0.47; set bmargin at screen 0.17\nset format x\nset xlabel " +
    gnuplot_text(heading_with_unit(quantity::omega)) + "\nset ylabel \"Δτ_z (" + unit(scale) + ")\"\n" +
    (is_zero ? "set yrange [-1:1]\n" : "") + "plot data using 1:(" + (is_zero ? "0" : "$4 * " + scale) +
    ") with lines lt 3 notitle\nunset multiplot\n";
  return { "harmonic_torque",
           "Above: torque of friction against the spin, of all harmonics of the load and of the first alone. "
           "Below: their difference Δτ_z, what the harmonics beyond the first add.",
           script,
           data_table(number_rows("Torque of friction against the spin",
                                  { { "omega", "rad/s" },
                                    { "tau_z, all harmonics", "N m" },
                                    { "tau_z, first harmonic", "N m" },
                                    { "difference", "N m" } },
                                  rows)),
           540,
           430 };
}

Plot one_way(Plot plot)
{
  plot.caption += std::string(plot.caption.empty() || plot.caption.back() == '.' ? "" : ".") +
                  " One-way: the load of rest is kept at every spin.";
  plot.script = "set label 99 \"one-way: load of rest kept\" at screen 0.01, screen 0.03 left font \",11\" "
                "textcolor rgb \"#555555\"\n" +
                plot.script;
  return plot;
}

} // namespace stemware::pipeline
