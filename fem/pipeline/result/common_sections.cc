#include "fem/pipeline/result/common_sections.h"

#include "fem/pipeline/result/curves.h"
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

Fields<BandedQuantity> band_fields(bool with_richardson)
{
  Fields<BandedQuantity> parts;
  for (const auto &[key, heading, description] : band_parts)
    parts.add({ key, "", description, part_of(key) });
  return Fields<BandedQuantity>{
    { "value", "", "Value in its unit.", [](const BandedQuantity &banded) { return banded.quantity.value; } },
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
      or_absent() }
  }.by([](const BandedQuantity &banded) { return banded.quantity.key; });
}

Fields<StudyAnswer> harmonics_fields()
{
  using Answer = StudyAnswer;
  return {
    { "load", "The load on the table at rest.", load_fields(),
      [](const Answer &answer) { return answer.contact.load; } },
    { "harmonic_effect", "Effect of the harmonics beyond the first on the terminal spin.",
      harmonic_effect_fields(), [](const Answer &answer) { return harmonic_effect(answer.spin.rows); } },
    { "torque_effect",
      "Effect of all harmonics beyond the first on the torque of friction; null if the load has one "
      "harmonic.",
      torque_change_fields(),
      [](const Answer &answer)
      {
        const std::vector<Truncation> rows = truncations_of(answer.spin);
        return rows.size() < 2 ? std::nullopt : std::optional(rows.back());
      } },
    { "truncation",
      "The answer by the number of harmonics. Torques are of one load, the complete study's, cut after n; "
      "each terminal spin is a balance of its own, and null if only those of the first and of all are "
      "solved.",
      truncation_fields(), [](const Answer &answer) { return truncations_of(answer.spin); } }
  };
}

void add_truncations(const StudyAnswer &answer, Results &results)
{
  const ring::TorqueEffects &effects = answer.spin.torque_effects;
  results.add_table("truncations",
                    truncation_fields().table(shown_truncations(truncations_of(answer.spin)), Face::page));
  results.add_table("torque_changes",
                    torque_change_columns(effects).table(points_of(effects.spins.size()), Face::picture),
                    Face::picture);
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
