#include "fem/pipeline/analysis/ring_quantities.h"

#include "fem/pipeline/coupling/study_load.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Number = std::optional<double>;
using Effect = ring::TorqueEffect;

template <typename Read>
auto in_state(std::optional<ring::RingState> ring::Answer::*state, Read read)
{
  return [=](const ring::Answer &answer)
  {
    using Value = std::decay_t<std::invoke_result_t<Read, const ring::RingState &>>;
    const auto &found = answer.*state;
    return found ? std::optional<Value>(std::invoke(read, *found)) : std::nullopt;
  };
}

double friction_torque(const ring::RingState &state)
{
  return state.friction.torque;
}

std::array<double, 2> force_of(const ring::RingState &state)
{
  return { state.friction.force_x, state.friction.force_y };
}

/// Returns a function that reads one member of an AtSpin, at half or at the full terminal spin.
auto of_effect(std::optional<Effect::AtSpin> Effect::*spin, double Effect::AtSpin::*value)
{
  return [=](const Truncation &row)
  {
    const auto &at_spin = row.effect.*spin;
    return at_spin ? Number(*at_spin.*value) : std::nullopt;
  };
}

template <typename Read>
auto over_rest(Read read)
{
  return [=](const Truncation &row)
  {
    const Number torque = read(row);
    return torque && row.torque_at_rest != 0 ? Number(*torque / row.torque_at_rest) : std::nullopt;
  };
}

const auto change_half = of_effect(&Effect::half, &Effect::AtSpin::change);
const auto change_terminal = of_effect(&Effect::terminal, &Effect::AtSpin::change);

const auto largest_change = [](const Truncation &row) { return row.effect.largest; };
const auto largest_at = [](const Truncation &row) { return row.effect.largest_at; };

Fields<LoadReport> all_load_fields()
{
  using Ring = ring::RingStack::Ring;
  using Load = LoadReport;
  const auto ring_fields = Fields<Ring>{ { "a", "N/rad", "Cosine coefficients a_0, a_1 …", &Ring::a },
                                         { "b", "N/rad", "Sine coefficients, b_0 = 0.", &Ring::b } };
  Fields<Load> fields = {
    { "radii", "m", "Radii of the rings.",
      [](const Load &load)
      {
        std::vector<double> radii;
        for (const Ring &ring : load.rings())
          radii.push_back(ring.radius);
        return radii;
      } },
    { "rings", "Harmonics of each ring, in the order of the radii.", ring_fields,
      [](const Load &load) { return load.rings(); } },
    { "a", "N/rad", "Cosine coefficients of the sum of the rings.",
      [](const Load &load) { return series_of(load)[0]; } },
    { "b", "N/rad", "Sine coefficients of the sum of the rings.",
      [](const Load &load) { return series_of(load)[1]; } },
    { "normal_force", "N", "N = 2π a_0.", &Load::normal_force, in_column("normal force") },
    { "moment", "N m", "M_N = (Σ y f, −Σ x f), about the centre of the rings.",
      [](const Load &load) {
        return std::array<double, 2>{ load.moment().x(), load.moment().y() };
      } },
    { "moment_ratio", "1",
      "|M_N| / (N R/2), R = Glass/Contact radius; for a load file, its ring radius. A first harmonic "
      "lifts off at 1, the glass tips at 2, on a flat land of outer radius r_o at 2 r_o/R.",
      &Load::moment_ratio, in_column("moment ratio at rest"), on_page("moment ratio at rest") },
    { "ring_radius", "m", "Radius of the single ring with the same N, M_N and first harmonic.", &Load::radius,
      in_column("radius of the equivalent ring at rest"), in_bands() },
    { "mean_radius", "m", "Σ f r / Σ f.", &Load::mean_radius, in_column("mean radius of the load at rest") },
    { "contact_fraction", "1",
      "Share of the land's area under pressure. On a crowned rim, whose contact is a band, an azimuth "
      "counts with its whole area if any of its points is under pressure. Without a contact: share of "
      "the azimuths with a positive load.",
      &Load::contact_fraction, in_column("share of the land's area under pressure at rest"),
      on_page("share of the land's area under pressure at rest"), in_bands() },
    { "azimuth_fraction", "1",
      "Share of the rim's azimuths with a point under pressure. Null for a land without a hole (plate, "
      "disc).",
      &Load::azimuth_fraction, in_bands("share of the azimuths under pressure at rest") },
    { "least_load", "N/rad",
      "Least load, interpolated between the azimuth lines by the trigonometric interpolant.", &Load::least,
      in_column("least load at rest"), in_bands() },
    { "peak_pressure", "Pa",
      "Largest pressure. On a hard table: of the profile p_0 (1 - x^2)^a across the rim that has the "
      "force and the moments of the contact. Null without a contact.",
      [](const Load &load) { return load.peak_pressure > 0 ? Number(load.peak_pressure) : std::nullopt; },
      in_bands("largest pressure at rest") },
    { "contact_width", "m",
      "Largest width of the contact across the rim at any azimuth. On a rough table: the width with 99 % "
      "of the azimuth's load. Null without a contact, and if the mesh does not resolve the contact "
      "across the rim.",
      &Load::contact_width, in_bands("largest width of the contact at rest") },
    { "mean_load", "N/rad", "", [](const Load &load) { return load.a(0); }, in_column("a_0 at rest") }
  };
  for (unsigned int n = 1; n <= n_harmonics_of_interest; ++n)
    for (const char letter : { 'a', 'b' })
    {
      const std::string order = std::to_string(n);
      const auto coefficient = [=](const Load &load)
      { return (letter == 'a' ? load.a(n) : load.b(n)) / load.a(0); };
      fields.add({ letter + order, "1", "", coefficient,
                   in_column(std::string(1, letter) + '_' + order + " / a_0 at rest"), in_bands() });
    }
  return fields;
}

} // namespace

double without_rounding(double value, double rounding)
{
  return std::abs(value) < rounding ? 0. : value;
}

void drop_rounding(std::optional<double> &value, double rounding)
{
  if (value)
    value = without_rounding(*value, rounding);
}

Fields<ring::RingState> fall_fields()
{
  return { { "omega", "rad/s", "The last spin in balance.", &ring::RingState::omega },
           { "moment_ratio", "1", "Moment ratio at this spin.", &ring::RingState::moment_ratio } };
}

const Fields<ring::Answer> &answer_fields()
{
  using ring::Answer;
  using ring::RingState;
  static const auto fields = Fields<Answer>{
    { "omega_terminal", "rad/s", "Terminal spin: zero of the sum of friction, lean and grip torque.",
      &Answer::omega_terminal, in_column("terminal spin"), on_page("terminal spin"), in_bands() },
    { "tau_at_rest", "N m",
      "Torque of friction on the glass at rest; the mean over the phases with waviness.",
      in_state(&Answer::at_rest, friction_torque), in_column("torque of friction at rest"),
      on_page("torque of friction at rest"), in_bands() },
    { "lean_torque_at_rest", "N m", "Torque of the normal forces about the tilted axis at rest.",
      in_state(&Answer::at_rest, &RingState::lean_torque) },
    { "fall", "Spin at which a glass that stands at rest tips over; null if it does not tip.", fall_fields(),
      &Answer::fall },
    { "tau_at_terminal", "N m",
      "Torque of friction at the terminal spin. With waviness, all keys that end in _at_terminal belong "
      "to the mean load at waviness/zero_of_mean_torque.",
      in_state(&Answer::at_terminal, friction_torque) },
    { "lean_torque_at_terminal", "N m", "Lean torque at the terminal spin.",
      in_state(&Answer::at_terminal, &RingState::lean_torque) },
    { "grip_torque_at_terminal", "N m", "Grip torque at the terminal spin.",
      in_state(&Answer::at_terminal, &RingState::grip_torque) },
    { "time_constant", "s", "Time constant of the approach to the terminal spin.", &Answer::time_constant,
      in_column("time constant"), in_bands() },
    { "force_at_terminal", "N", "Friction force (T_x, T_y) at the terminal spin.",
      in_state(&Answer::at_terminal, force_of) },
    { "moment_ratio_at_terminal", "1", "Moment ratio at the terminal spin.",
      in_state(&Answer::at_terminal, &RingState::moment_ratio) }
  };
  return fields;
}

std::array<std::vector<double>, 2> series_of(const ring::RingStack &load)
{
  std::array<std::vector<double>, 2> series;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    series[0].push_back(load.a(n));
    series[1].push_back(load.b(n));
  }
  return series;
}

const Fields<LoadReport> &load_fields()
{
  static const Fields<LoadReport> fields = all_load_fields();
  return fields;
}

std::vector<Truncation> truncations_of(const SpinStudy &spin)
{
  const StudyRows &rows = spin.rows;
  const ring::TorqueEffects &effects = spin.torque_effects;
  const double scale = rows.by_harmonics.back().variant.study.spin_scale();
  std::vector<Truncation> list;
  for (const ring::TorqueEffect &effect : effects.rows)
  {
    Truncation &row = list.emplace_back(Truncation{ {}, effect, effects.torque_at_rest, {} });
    row.answer.harmonics = effect.harmonics;
    for (const LoadedRow &solved : rows.by_harmonics)
      if (solved.row.harmonics == effect.harmonics)
      {
        row.answer = solved.row;
        break;
      }
    row.spin_change =
      harmonic_effect(rows.omega_first_harmonic(), row.answer.omega_terminal(), scale).relative;
  }
  return list;
}

std::vector<Truncation> shown_truncations(std::vector<Truncation> rows)
{
  const auto &at_rest = rows.back().answer.at_rest;
  const double torque = at_rest ? std::abs(at_rest->friction.torque) : 0;
  std::vector<Truncation> shown;
  for (Truncation &row : rows)
  {
    const auto &terminal = row.effect.terminal;
    if (&row != &rows.back() && terminal && !(std::abs(terminal->rest) > 1e-9 * torque))
      continue;
    for (auto *at_spin : { &row.effect.half, &row.effect.terminal })
      if (*at_spin)
        for (double *value : { &(*at_spin)->change, &(*at_spin)->rest })
          *value = without_rounding(*value, 1e-12 * torque);
    drop_rounding(row.effect.largest, 1e-12 * torque);
    drop_rounding(row.spin_change, 1e-11);
    shown.push_back(row);
  }
  return shown;
}

Fields<Truncation> torque_change_fields()
{
  return { { "half", "N m", "At half the terminal spin.", change_half },
           { "half_relative", "1", "The same over |τ_z| at rest.", over_rest(change_half) },
           { "terminal", "N m", "At the terminal spin.", change_terminal },
           { "terminal_relative", "1", "The same over |τ_z| at rest.", over_rest(change_terminal) },
           { "largest", "N m",
             "Value of largest size between rest and the terminal spin, or the spin at which the glass tips.",
             largest_change },
           { "largest_relative", "1", "The same over |τ_z| at rest.", over_rest(largest_change) },
           { "largest_at", "rad/s", "Spin of the largest value.", largest_at } };
}

Fields<Truncation> truncation_fields()
{
  using ring::Answer;
  const auto self = [](const Truncation &row) -> const Truncation & { return row; };
  const auto answer = [](auto read)
  { return [=](const Truncation &row) { return std::invoke(read, row.answer); }; };
  const auto rest_fields = Fields<Truncation>{
    { "half", "N m", "At half the terminal spin.", of_effect(&Effect::half, &Effect::AtSpin::rest) },
    { "terminal", "N m", "At the terminal spin.", of_effect(&Effect::terminal, &Effect::AtSpin::rest) }
  };
  return {
    { "harmonics", "1", "Harmonics kept.", answer(&Answer::harmonics), in_file("harmonics", "harmonics kept"),
      shown_as("harmonics") },
    { "tau_at_rest", "N m", "Torque of friction at rest.",
      answer(in_state(&Answer::at_rest, friction_torque)),
      in_file("tau_z at rest", "torque of friction at rest") },
    { "torque_change",
      "Δτ_z(n) = τ_z(n) − τ_z(1) of the torque of friction: the complete study's load at each spin, "
      "cut after n harmonics, without a new balance; means over the phases with waviness. Relative "
      "values are over |τ_z| at rest.",
      torque_change_fields(), self },
    { "torque_rest", "τ_z(all) − τ_z(n), the effect of the harmonics that are left out.", rest_fields, self },
    { "change_half", "N m", "", change_half,
      in_file("change of tau_z at half the terminal spin", "tau_z(n) - tau_z(1) at half the terminal spin"),
      on_page("Δτ_z(n) at half spin"), on_console("torque change\nat half spin"), with_digits("+.3g") },
    { "change_half_relative", "1", "", over_rest(change_half),
      in_file("change of tau_z at half the terminal spin over |tau_z| at rest",
              "the same over the torque at rest"),
      on_page("over |τ_z(0)|"), on_console("over that\nat rest"), with_digits("+.3g%") },
    { "change_terminal", "N m", "", change_terminal,
      in_file("change of tau_z at the terminal spin", "tau_z(n) - tau_z(1) at the terminal spin"),
      on_page("Δτ_z(n) at the terminal spin"), on_console("at the\nterminal spin"), with_digits("+.3g") },
    { "change_terminal_relative", "1", "", over_rest(change_terminal),
      in_file("change of tau_z at the terminal spin over |tau_z| at rest",
              "the same over the torque at rest"),
      on_page("over |τ_z(0)|"), on_console("over that\nat rest"), with_digits("+.3g%") },
    { "change_largest", "N m", "", largest_change,
      in_file("largest change of tau_z from rest to the terminal spin",
              "largest tau_z(n) - tau_z(1) between rest and the terminal spin") },
    { "change_largest_at", "rad/s", "", largest_at,
      in_file("omega of the largest change", "spin of the largest change") },
    { "rest_half", "N m", "", of_effect(&Effect::half, &Effect::AtSpin::rest),
      in_file("tau_z of all harmonics minus tau_z(n) at half the terminal spin",
              "tau_z(all) - tau_z(n) at half the terminal spin") },
    { "bound_half", "N m", "A-priori bound on the absolute value of the rest at half the terminal spin.",
      of_effect(&Effect::half, &Effect::AtSpin::bound),
      in_file("a-priori bound on that rest at half the terminal spin",
              "a-priori bound on its absolute value") },
    { "rest_terminal", "N m", "", of_effect(&Effect::terminal, &Effect::AtSpin::rest),
      in_file("tau_z of all harmonics minus tau_z(n) at the terminal spin",
              "tau_z(all) - tau_z(n) at the terminal spin"),
      on_page("rest τ_z(all) − τ_z(n)"), on_console("rest there,\nall minus n"), with_digits("+.2e") },
    { "bound", "N m", "A-priori bound on the absolute value of the rest at the terminal spin.",
      of_effect(&Effect::terminal, &Effect::AtSpin::bound),
      in_file("a-priori bound on the rest of tau_z at the terminal spin",
              "a-priori bound on its absolute value"),
      on_page("bound on the rest"), on_console("bound on\nthe rest"), with_digits(".2e") },
    { "omega_terminal", "rad/s", "Terminal spin.", answer(&Answer::omega_terminal),
      in_file("terminal omega", "terminal spin"), shown_as("terminal spin"), with_digits("#.4g") },
    { "relative_change", "1", "Relative change from all harmonics.", answer(&Answer::relative_change),
      in_file("relative change of terminal omega to all harmonics, nan where that is 0",
              "relative change of the terminal spin to all harmonics") },
    { "spin_change", "1", "", &Truncation::spin_change, on_page("change of spin"),
      on_console("change\nof spin"), with_digits("+.3g%") },
    { "least_load", "N/rad", "Least load at rest.",
      answer(in_state(&Answer::at_rest, &ring::RingState::minimum)),
      in_file("least load at rest", "least load at rest") },
    { "pulling_share", "1", "Tensile (not physical) part of the load at rest, over N.",
      answer(in_state(&Answer::at_rest, &ring::RingState::pulling_share)) },
    { "message", "", "Reason for missing values.",
      [](const Truncation &row) { return text_or_null(row.answer.reason); } }
  };
}

} // namespace stemware::pipeline
