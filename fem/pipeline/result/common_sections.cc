#include "fem/pipeline/result/common_sections.h"

#include "fem/pipeline/result/number_format.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

/// Part of an error band. `key`: name in BandedQuantity::parts and summary.json; `description`: cause of the
/// error.
struct BandPart
{
  const char *key, *heading, *description;
};

constexpr BandPart band_parts[] = {
  { "mesh", "mesh", "From the cells; with a body of revolution, from their degree too." },
  { "degree", "degree", "From the degree of solid elements." },
  { "harmonics", "harmonics", "From the elastic harmonics." },
  { "lines", "lines", "From the lines along which the table law is integrated." },
  { "interface", "interface", "From the penalty of a hard table." },
  { "load_harmonics", "load harmonics", "From the harmonics of the load." },
  { "rings", "rings", "From the number of rings." },
  { "interpolation", "interpolation", "From the interpolant over spin and phase." },
  { "solver", "solver", "From the tolerances of the solvers." }
};

auto part_of(const std::string &key)
{
  return [key](const BandedQuantity &banded)
  {
    const auto part = banded.parts.find(key);
    return part == banded.parts.end() ? std::nullopt : std::optional(part->second);
  };
}

std::string title_of_band(const BandedQuantity &banded)
{
  return banded.quantity.title();
}

} // namespace

const Fields<LoadReport> &load_fields()
{
  using Ring = ring::RingStack::Ring;
  using Load = LoadReport;
  static const auto ring_fields = Fields<Ring>{ { "a", "N/rad", "Cosine coefficients a_0, a_1 …", &Ring::a },
                                                { "b", "N/rad", "Sine coefficients, b_0 = 0.", &Ring::b } };
  static const auto fields = Fields<Load>{
    { "radii", "m", "Radii of the rings.",
      [](const Load &load)
      {
        std::vector<double> radii;
        for (const Ring &ring : load.rings.rings())
          radii.push_back(ring.radius);
        return radii;
      } },
    { "rings", "Harmonics of each ring, in the order of the radii.", ring_fields,
      [](const Load &load) { return load.rings.rings(); } },
    { "a", "N/rad", "Cosine coefficients of the sum of the rings.",
      [](const Load &load) { return series_of(load.rings)[0]; } },
    { "b", "N/rad", "Sine coefficients of the sum of the rings.",
      [](const Load &load) { return series_of(load.rings)[1]; } },
    { "normal_force", "N", "N = 2π a_0.", &Load::normal_force },
    { "moment", "N m", "M_N = (Σ y f, −Σ x f), about the centre of the rings.",
      [](const Load &load) {
        return std::array<double, 2>{ load.moment.x(), load.moment.y() };
      } },
    { "moment_ratio", "1",
      "|M_N| / (N R/2), R = Glass/Contact radius; for a load file, its ring radius. A first harmonic "
      "lifts off at 1, the glass tips at 2, on a flat land of outer radius r_o at 2 r_o/R.",
      &Load::moment_ratio },
    { "ring_radius", "m", "Radius of the single ring with the same N, M_N and first harmonic.",
      [](const Load &load) { return load.rings.radius(); } },
    { "mean_radius", "m", "Σ f r / Σ f.", &Load::mean_radius },
    { "contact_fraction", "1",
      "Share of the land's area under pressure. On a crowned rim, whose contact is a band, an azimuth "
      "counts with its whole area if any of its points is under pressure. Without a contact: share of "
      "the azimuths with a positive load.",
      &Load::contact_fraction },
    { "azimuth_fraction", "1",
      "Share of the rim's azimuths with a point under pressure. Null for a land without a hole (plate, "
      "disc).",
      &Load::azimuth_fraction },
    { "minimum", "N/rad",
      "Minimum load, interpolated between the azimuth lines by the trigonometric interpolant.",
      &Load::minimum },
    { "peak_pressure", "Pa",
      "Largest pressure. On a hard table: of the profile p_0 (1 - x^2)^a across the rim that has the "
      "force and the moments of the contact. Null without a contact.",
      &Load::peak_pressure },
    { "contact_width", "m",
      "Largest width of the contact across the rim at any azimuth. On a rough table: the width with 99 % "
      "of the azimuth's load. Null without a contact, and if the mesh does not resolve the contact "
      "across the rim.",
      &Load::contact_width }
  };
  return fields;
}

Fields<BandedQuantity> band_fields(bool with_richardson)
{
  Fields<BandedQuantity> parts;
  for (const auto &[key, heading, description] : band_parts)
    parts.add({ key, "", description, part_of(key) });
  return { { "value", "", "Value in its unit.",
             [](const BandedQuantity &banded) { return banded.quantity.value; } },
           { "band", "", "Half-width: the exact solution of the model lies within value ± band.",
             &BandedQuantity::band },
           { "parts", "Parts of the band by cause; null if a part was not estimated.", parts,
             [](const BandedQuantity &banded) -> const BandedQuantity & { return banded; } },
           { "unit", "", "SI unit; \"1\" for pure numbers.",
             [](const BandedQuantity &banded) { return banded.quantity.unit; } },
           { "omega", "rad/s",
             "Spin of tau_at_spin_1 and tau_at_spin_2: half and one and a half times the terminal spin.",
             [](const BandedQuantity &banded) { return banded.quantity.omega; }, or_absent() },
           { "richardson", "", "Extrapolated value, from `converge` only.",
             [=](const BandedQuantity &banded)
             { return with_richardson ? std::optional(banded.richardson) : std::nullopt; },
             or_absent() } };
}

std::string key_of_band(const BandedQuantity &banded)
{
  return banded.quantity.key;
}

std::vector<Truncation> truncations_of(const StudyAnswer &answer)
{
  return truncations_of(answer.spin.rows, answer.spin.torque_effects, answer.study.spin_scale());
}

const Fields<StudyAnswer> &harmonics_fields()
{
  using Answer = StudyAnswer;
  static const auto fields = Fields<Answer>{
    { "load", "The load on the table at rest.", load_fields(),
      [](const Answer &answer) { return answer.contact.load; } },
    { "harmonic_effect", "Effect of the harmonics beyond the first on the terminal spin.",
      harmonic_effect_fields(), [](const Answer &answer) { return answer.spin.budget.harmonics; } },
    { "torque_effect",
      "Effect of all harmonics beyond the first on the torque of friction; null if the load has one "
      "harmonic.",
      torque_change_fields(),
      [](const Answer &answer)
      {
        const std::vector<Truncation> rows = truncations_of(answer);
        return rows.size() < 2 ? std::nullopt : std::optional(rows.back());
      } },
    { "truncation",
      "The answer by the number of harmonics. Torques are of one load, the complete study's, cut after n; "
      "each terminal spin is a balance of its own, and null if only those of the first and of all are "
      "solved.",
      truncation_fields(), [](const Answer &answer) { return truncations_of(answer); } }
  };
  return fields;
}

void add_truncations(const StudyAnswer &answer, Results &results)
{
  const ring::TorqueEffects &effects = answer.spin.torque_effects;
  results.add_table("truncations",
                    truncation_fields().table(shown_truncations(truncations_of(answer)), Face::page));
  std::vector<std::pair<std::string, std::vector<double>>> curves = { { "omega", effects.spins } };
  for (const ring::TorqueEffect &effect : effects.rows)
    if (effect.harmonics > 1)
      curves.emplace_back(std::to_string(effect.harmonics), effect.curve);
  results.add_columns("torque_changes", curves);
}

void add_band_tables(const std::vector<BandedQuantity> &bands, Results &results)
{
  static const auto fields = Fields<BandedQuantity>{
    { "quantity", "", "", title_of_band, on_page("quantity") },
    { "shown_value", "", "",
      [](const BandedQuantity &banded)
      { return format::rounded_to_error(banded.quantity.value, banded.band); },
      on_page("value") },
    { "band", "1", "", &BandedQuantity::band, on_page("band"), with_digits("band") },
    { "shown_richardson", "", "",
      [](const BandedQuantity &banded) { return format::rounded_to_error(banded.richardson, banded.band); },
      on_page("Richardson value") },
    { "shown_unit", "", "",
      [](const BandedQuantity &banded)
      { return banded.quantity.unit == "1" ? std::string(format::missing) : banded.quantity.unit; },
      on_page("unit") }
  };
  std::vector<BandedQuantity> listed;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(listed),
               [](const BandedQuantity &each) { return !each.is_zero(); });
  results.add_table("bands", fields.table(listed, Face::page));
  Fields<BandedQuantity> parts;
  parts.add({ "quantity", "", "", title_of_band, on_page("quantity") });
  for (const auto &[key, heading, description] : band_parts)
    if (std::any_of(listed.begin(), listed.end(), part_of(key)))
      parts.add({ heading, "1", "", part_of(key), on_page(heading), with_digits("band") });
  if (parts.all().size() > 1)
    results.add_table("band_parts", parts.table(listed, Face::page));
}

} // namespace stemware::pipeline
