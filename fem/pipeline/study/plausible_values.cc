#include "fem/pipeline/study/plausible_values.h"

#include "fem/pipeline/study/idle_entries.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{

const std::vector<PlausibleRange> &plausible_ranges()
{
  static const std::vector<PlausibleRange> ranges = {
    { "Motion/Mass", 0.02, 2, "a liqueur glass to a full beer mug" },
    { "Motion/Yaw inertia", 1e-6, 1e-2, "20 g at 7 mm from the axis to 2 kg at 7 cm" },
    { "Motion/Centre of mass height", 0.01, 0.3, "a liqueur glass to a tall flute" },
    { "Motion/Force offset", -0.3, 0.3, "the hand on the glass" },
    { "Motion/Orbit radius", 0.01, 2, "fingers to a whole arm" },
    { "Motion/Orbit speed", 0.01, 3, "hardly moving to as fast as a hand can lead" },
    { "Motion/Friction coefficient", 0.02, 1.5, "wet and soapy to clean rubber" },
    { "Motion/Static friction coefficient", 0.02, 2, "wet and soapy to clean rubber" },
    { "Motion/Friction decay speed", 1e-4, 1, "creeping to as fast as the glass is led" },
    { "Motion/Viscous friction", 0, 10, "dry to a thick film of syrup" },
    { "Motion/Gravity", 1, 30, "the Moon (1.6) to Jupiter (25)" },
    { "Motion/Grip torque", 0, 0.1, "no grip to 10 N of fingers on a stem of 1 cm" },
    { "Motion/End time", 0.01, 1000, "a hundredth of a second to a quarter of an hour" },
    { "Glass/Contact radius", 0.005, 0.1, "a liqueur glass to a carafe" },
    { "Glass/Foot radius", 0.006, 0.12, "a liqueur glass to a carafe" },
    { "Glass/Foot thickness", 5e-4, 0.03, "the thinnest blown foot to a pressed base" },
    { "Glass/Land width", 1e-4, 0.03, "a ground edge to a broad ring" },
    { "Glass/Land height", 1e-5, 0.02, "a polished to a deep ring" },
    { "Glass/Crown radius", 1e-4, 0.2, "a ground edge to a rim that is nearly flat; 0 is a flat land" },
    { "Glass/Underside rise", 0, 0.03, "flat to a deep kick" },
    { "Glass/Edge thickness", 2e-4, 0.02, "the thinnest blown foot to a pressed base" },
    { "Glass/Fillet radius", 0, 0.05, "a sharp corner to a trumpet foot" },
    { "Glass/Stem radius", 0.0015, 0.06, "a drawn stem to the body of a tumbler" },
    { "Glass/Stem height", 5e-4, 0.2, "a cut close to the foot to the longest stem" },
    { "Glass/Young modulus", 1e9, 2.5e11, "plastic (2 GPa), lead crystal (60), soda lime (70), steel (210)" },
    { "Glass/Poisson ratio", 0, 0.49, "cork (0) to nearly incompressible" },
    { "Table/Foundation modulus", 1e7, 1e14, "5 cm of foam to a micrometre of dirt" },
    { "Table/Layer thickness", 0, 0.1, "a film to a cushion" },
    { "Table/Reference pressure", 1e5, 1e11, "a tenth of the softer body's modulus" },
    { "Table/Decay length", 1e-9, 1e-4, "float glass to sawn wood: half the rms roughness" },
    { "Table/Disc radius", 0.02, 3, "larger than the foot, up to a table" },
    { "Table/Disc thickness", 1e-4, 0.5, "a tablecloth to a block" },
    { "Table/Disc Young modulus", 1e5, 1.2e12, "foam to diamond" },
    { "Table/Disc Poisson ratio", -0.2, 0.499, "cork (0), wood (0.3), rubber (0.49)" },
    { "Load/Moment direction", -6.2832, 6.2832, "one turn either way" },
  };
  return ranges;
}

namespace
{

/// The range that @p value of an entry is outside of; null where it has none, or a value that it may have.
const PlausibleRange *range_left_by(const std::string &path, double value)
{
  const auto &ranges = plausible_ranges();
  const auto range = std::find_if(ranges.begin(), ranges.end(),
                                  [&](const PlausibleRange &candidate) { return candidate.path == path; });
  const bool is_fine = range == ranges.end() || value == 0 || (range->least <= value && value <= range->most);
  return is_fine ? nullptr : &*range;
}

/// " m", empty for pure numbers.
std::string unit_behind_number(const std::string &path)
{
  const std::string si = unit_of(path);
  return si == "1" ? "" : ' ' + si;
}

/// Paths and values of the quantities that a study was given and that have an effect.
std::vector<std::pair<std::string, double>> given_quantities(const Study &study)
{
  const std::vector<std::string> idle = idle_entries(study);
  Study copy = study;
  std::vector<std::pair<std::string, double>> given;
  for (const StudyEntry &entry : study_entries(copy))
    if (entry.is_quantity && study.given_entries.count(entry.path()) > 0 &&
        std::find(idle.begin(), idle.end(), entry.path()) == idle.end())
      given.emplace_back(entry.path(), entry.json().get<double>());
  return given;
}

} // namespace

std::string implausible_note(const std::string &path, double value)
{
  const PlausibleRange *range = range_left_by(path, value);
  if (range == nullptr)
    return "";
  const std::string si = unit_of(path), number = to_short_text(value), unit = unit_behind_number(path);
  std::string meant;
  for (const std::string &usual : usual_units(si))
    if (const auto other = parse_quantity(number + ' ' + usual, si);
        meant.empty() && other && range->least <= *other && *other <= range->most)
      meant = fmt::format(FMT_STRING("write {} {} if that is meant"), number, usual);
  return fmt::format(FMT_STRING("{} = {}{} is outside {} to {}{} for a glass; {}."), path, number, unit,
                     to_short_text(range->least), to_short_text(range->most), unit,
                     meant.empty() ? "check number and unit" : meant);
}

void require_conceivable(const Study &study)
{
  constexpr double far = 1e9;
  Study copy = study;
  for (const StudyEntry &entry : study_entries(copy))
    for (const PlausibleRange &range : plausible_ranges())
    {
      if (range.path != entry.path() || study.given_entries.count(range.path) == 0)
        continue;
      const double value = std::abs(entry.json().get<double>());
      const double most = std::max(std::abs(range.least), range.most), least = std::max(range.least, 0.);
      require(value <= far * most && (value == 0 || value >= least / far),
              fmt::format(FMT_STRING("{} = {} {} is more than a billion times outside {} to {} {}, {}; check "
                                     "number and unit."),
                          range.path, to_short_text(entry.json().get<double>()), entry.unit,
                          to_short_text(range.least), to_short_text(range.most), entry.unit, range.reason));
    }
}

std::vector<std::string> implausible_notes(const Study &study)
{
  std::vector<std::string> notes;
  for (const auto &[path, value] : given_quantities(study))
    if (const std::string note = implausible_note(path, value); !note.empty())
      notes.push_back(note);
  return notes;
}

std::string implausible_list(const Study &study)
{
  std::string list;
  for (const auto &[path, value] : given_quantities(study))
    if (const PlausibleRange *range = range_left_by(path, value))
      list += fmt::format(FMT_STRING("{}{} = {}{} ({} to {}{})"), list.empty() ? "" : ", ", path,
                          to_short_text(value), unit_behind_number(path), to_short_text(range->least),
                          to_short_text(range->most), unit_behind_number(path));
  return list;
}

} // namespace stemware::pipeline
