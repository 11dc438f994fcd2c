// A changed entry must change the terminal spin in the first base study to which the entry applies. The list
// `effects` contains the exceptions.
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/result/verb_results.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <regex>
#include <set>

namespace stemware::pipeline
{
namespace
{

using Json = nlohmann::ordered_json;
using EntryValues = std::vector<std::pair<std::string, std::string>>;

struct Effect
{
  std::string entry; ///< "Section/Entry"
  std::string value;
  /// Path of the value in summary.json that must change, or "/spin_up.csv"; empty if the entry has no effect.
  std::string changed;
  EntryValues base = {};  ///< entries set in the base study
  std::string stays = {}; ///< path of a number that must not change
};

std::ostream &operator<<(std::ostream &stream, const Effect &effect)
{
  return stream << effect.entry << " = " << effect.value;
}

const EntryValues foot = { { "Glass/Shape", "foot" } };
const EntryValues elastic = { { "Table/Interface", "hard" }, { "Table/Substrate", "elastic" } };
const EntryValues rough = { { "Table/Interface", "rough" } };
const EntryValues two_way = { { "Load/Coupling", "two-way" } };
const EntryValues from_rest = { { "Load/Coupling", "two-way" }, { "Motion/Orbit speed file", "start.csv" } };
const EntryValues slow_decay = { { "Motion/Friction decay speed", "0.3" } };
const EntryValues stribeck = { { "Motion/Friction law", "Stribeck" },
                               { "Motion/Friction decay speed", "0.3" } };
const EntryValues filled = { { "Motion/Liquid mass", "0.1" } };
const EntryValues given_moment = { { "Load/Moment ratio", "0.5" } };
const EntryValues from_file = { { "Load/Source", "file" }, { "Load/File", "one.dat" } };
const EntryValues solid = { { "Contact/Body", "solid" },
                            { "Contact/Degree", "1" },
                            { "Contact/Azimuthal cells", "16" },
                            { "Contact/Radial cells", "2" },
                            { "Contact/Foot layers", "1" } };

EntryValues drawn(EntryValues values)
{
  values.insert(values.end(), { { "Glass/Shape", "profile" },
                                { "Glass/Profile file", "thick.csv" },
                                { "Glass/Crown radius", "0.003" } });
  return values;
}

EntryValues with(EntryValues values, const std::string &entry, const std::string &value)
{
  values.emplace_back(entry, value);
  return values;
}

const EntryValues solid_rough = with(solid, "Table/Interface", "rough");
const EntryValues crowned_mesh = with(solid, "Contact/Mesh file", STEMWARE_MESHES "/crowned_foot.msh");
const EntryValues quadratic_solid = with(solid, "Contact/Degree", "2");

/// Solid foot with an accuracy goal that the first mesh meets.
const EntryValues solid_for_a2 = with(with(solid, "Contact/Goal", "a2"), "Contact/Goal tolerance", "1");

const std::string nothing, second_harmonic = "/load/a/2", unknowns = "/contact/unknowns";

const std::vector<Effect> effects = {
  { "Motion/Yaw inertia", "6e-4", "/ring/time_constant", {}, "/ring/omega_terminal" },
  { "Motion/Hand height", "0.04", "/load/moment_ratio" },
  { "Motion/Liquid mass", "0.1", "/load/normal_force" },
  { "Motion/Bowl depth", "0.1", nothing, filled, "/ring/omega_terminal" },
  { "Motion/Orbit speed file", "speeds.csv", "/ring/driven", two_way },
  { "Motion/Breakaway friction", "0.5", "/ring/driven/breakaway/force", from_rest, "/ring/omega_terminal" },
  { "Motion/Friction law", "Stribeck", "/ring/omega_terminal", slow_decay },
  { "Motion/End time", "1", "/spin_up.csv", {}, "/ring/omega_terminal" },
  { "Motion/Euler step", "0.01", "/spin_up.csv", {}, "/ring/omega_terminal" },
  { "Motion/Step limit", "1e7", nothing, {}, "/ring/omega_terminal" },
  { "Glass/Profile file", "thin.csv", second_harmonic, drawn({}) },
  { "Glass/Profile file", "thin.csv", second_harmonic, drawn(solid) },
  { "Glass/Contact radius", "0.031", "/load/ring_radius" },
  { "Glass/Foot radius", "0.036", second_harmonic },
  { "Glass/Foot radius", "0.036", second_harmonic, foot },
  { "Glass/Foot thickness", "0.005", second_harmonic },
  { "Glass/Foot thickness", "0.005", second_harmonic, foot },
  { "Glass/Land width", "0.003", second_harmonic },
  { "Glass/Land width", "0.003", second_harmonic, foot },
  { "Glass/Land height", "0.002", second_harmonic },
  { "Glass/Land height", "0.0015", second_harmonic, foot },
  { "Glass/Underside rise", "0.002", second_harmonic, foot },
  { "Glass/Underside rise", "0.002", nothing, {}, second_harmonic },
  { "Glass/Stem radius", "0.007", second_harmonic },
  { "Glass/Stem radius", "0.004", second_harmonic, foot },
  { "Glass/Stem radius", "0.007", second_harmonic, solid },
  { "Glass/Rim waviness", "2: 1e-6", second_harmonic },
  { "Glass/Young modulus", "5e10", second_harmonic },
  { "Glass/Young modulus", "5e10", second_harmonic, solid },
  { "Glass/Poisson ratio", "0.3", second_harmonic },
  { "Glass/Poisson ratio", "0.3", second_harmonic, solid },
  { "Table/Interface", "hard", second_harmonic },
  { "Table/Interface", "rough", second_harmonic },
  { "Table/Interface", "rough", second_harmonic, elastic },
  { "Table/Foundation modulus", "1e9", second_harmonic },
  { "Table/Foundation modulus", "1e9", second_harmonic, solid },
  { "Table/Layer thickness", "0.005", nothing, {}, second_harmonic },
  // The pressure of the rough interface is exponential in the penetration. A factor on the reference pressure
  // is therefore equivalent to a shift of the table and leaves the spin unchanged.
  { "Table/Reference pressure", "2e9", "/contact/table_motion/0", rough, "/ring/omega_terminal" },
  { "Table/Reference pressure", "2e9", "/contact/table_motion/0", solid_rough, "/ring/omega_terminal" },
  { "Table/Decay length", "2e-6", second_harmonic, rough },
  { "Table/Decay length", "2e-6", second_harmonic, solid_rough },
  { "Table/Disc radius", "0.1", second_harmonic, elastic },
  { "Table/Disc thickness", "0.02", second_harmonic, elastic },
  { "Table/Waviness", "2: 1e-6", second_harmonic },
  { "Contact/Body", "revolution", unknowns, solid },
  { "Contact/Mesh file", std::string(STEMWARE_MESHES) + "/crowned_foot.msh", second_harmonic, solid },
  { "Contact/Mesh unit", "mm", nothing, {}, second_harmonic },
  { "Contact/Mesh contact id", "3", nothing, {}, second_harmonic },
  { "Contact/Mesh stem id", "3", nothing, {}, second_harmonic },
  { "Contact/Mesh contact height", "5e-5", "/contact/contact_nodes", crowned_mesh },
  { "Contact/Degree", "1", unknowns },
  { "Contact/Degree", "2", unknowns, solid },
  { "Contact/Azimuthal cells", "20", unknowns, solid },
  { "Contact/Azimuthal cells", "20", nothing, {}, second_harmonic },
  { "Contact/Radial cells", "8", unknowns },
  { "Contact/Radial cells", "4", unknowns, solid },
  { "Contact/Foot layers", "3", nothing, {}, second_harmonic },
  { "Contact/Foot layers", "2", unknowns, solid },
  { "Contact/Refinements", "1", unknowns },
  { "Contact/Land grading", "1", second_harmonic },
  { "Contact/Linear solver", "condensed", "/contact/linear_iterations", quadratic_solid, second_harmonic },
  { "Contact/Harmonics", "2", "/load/a/4" },
  { "Contact/Azimuth lines", "96", "/contact/contact_nodes" },
  { "Contact/Rings", "1", "/ring/omega_terminal" },
  { "Contact/Load harmonics", "2", "/load/a" },
  { "Contact/Friction coupling", "elastic", second_harmonic },
  { "Contact/Friction coupling", "elastic", second_harmonic, solid },
  { "Contact/Goal", "torque", "/goal/value", solid_for_a2, second_harmonic },
  { "Contact/Goal tolerance", "2", "/goal/tolerance", solid_for_a2, second_harmonic },
  { "Contact/Memory limit", "8e9", nothing, {}, second_harmonic },
  { "Motion/Centre of mass height", "0.09", "/ring/omega_terminal", two_way },
  { "Load/Moment ratio", "0.5", "/load/moment_ratio" },
  { "Load/Moment direction", "0.5", "/load/moment/1", given_moment },
  { "Load/File", "two.dat", "/load/a/1", from_file },
};

/// Returns the summary of a study. Adds the table of the spin-up as "spin_up.csv".
Json results_of(const Study &study)
{
  fem::ComplianceCache cache;
  const StudyAnswer answer = answer_study(study, Depth::answer, ThreadedExecutor(cache), false);
  const Results results = run_results(answer);
  Json all = results.summary;
  for (const ResultFile &file : results.files)
    if (file.name == "spin_up.csv")
      all["spin_up.csv"] = data_table(std::get<Table>(file.content));
  return all;
}

/// Returns the base study of @p effect, with the changed entry if @p with_value. Few harmonics and lines save
/// time.
Study study_of(const Effect &effect, bool with_value, const test::ScratchFolder &scratch)
{
  EntryValues values = { { "Glass/Shape", "step" },
                         { "Contact/Harmonics", "6" },
                         { "Contact/Azimuth lines", "64" },
                         { "Contact/Friction coupling", "none" },
                         { "Load/Coupling", "one-way" } };
  values.insert(values.end(), effect.base.begin(), effect.base.end());
  if (with_value)
    values.emplace_back(effect.entry, effect.value);
  for (auto &[entry, value] : values)
    if (entry == "Load/File" || entry == "Glass/Profile file" || entry == "Motion/Orbit speed file")
      value = scratch / value;
  return with_values(test::mat_study(), "the list of effects", values);
}

class EntryEffects : public testing::TestWithParam<Effect>
{
protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite() { shared.reset(); }

  static Json results_of_base()
  {
    const Study study = study_of(GetParam(), false, shared->scratch);
    const std::string text = study_as_prm(study);
    const auto known = shared->of_bases.find(text);
    return known != shared->of_bases.end() ? known->second : shared->of_bases[text] = results_of(study);
  }

  static Json results_with_the_value() { return results_of(study_of(GetParam(), true, shared->scratch)); }

private:
  struct Shared
  {
    const test::ScratchFolder scratch;
    std::map<std::string, Json> of_bases; ///< key: text of the study file
  };
  static inline std::unique_ptr<Shared> shared;
};

void EntryEffects::SetUpTestSuite()
{
  shared = std::make_unique<Shared>();
  const test::ScratchFolder &scratch = shared->scratch;
  scratch.write("one.dat", "# ring radius: 0.03 (m)\n0 0.4 0\n1 0.1 0.1\n");
  scratch.write("speeds.csv", "t (s), v (m/s)\n0, 0.2\n3, 0.4\n");
  scratch.write("start.csv", "t (s), v (m/s)\n0, 0\n3, 0.4\n");
  scratch.write("two.dat", "# ring radius: 0.03 (m)\n0 0.4 0\n1 0.2 0.1\n");
  const std::string plate = "0,0.002\n0.027,0.0015\n0.03,0\n0.033,0.0015\n0.034,0.002\n";
  scratch.write("thick.csv", plate + "0.034,0.006\n0.006,0.006\n0.006,0.02\n0,0.02\n");
  scratch.write("thin.csv", plate + "0.034,0.004\n0.006,0.004\n0.006,0.02\n0,0.02\n");
}

TEST_P(EntryEffects, AChangedEntryChangesAndKeepsTheListedResults)
{
  const Json before = results_of_base();
  const Json after = results_with_the_value();
  // Minimum relative change: above the solver tolerance (1e-9), below the effect of the stem height (8e-6).
  constexpr double least = 1e-7;
  if (const Json::json_pointer changed(GetParam().changed); changed.empty())
    EXPECT_EQ(after, before);
  else if (before.at(changed).is_number() && after.contains(changed))
  {
    const double one = before[changed], other = after[changed];
    EXPECT_GT(std::abs(other - one), least * std::max(std::abs(one), std::abs(other)));
  }
  else
    EXPECT_NE(after.value(changed, Json()), before[changed]);
  if (GetParam().stays.empty())
    return;
  const Json::json_pointer stays(GetParam().stays);
  const double one = before.at(stays), other = after.at(stays);
  EXPECT_NEAR(other, one, least * std::abs(one));
}

std::string name_of(const testing::TestParamInfo<Effect> &info)
{
  std::string name = std::to_string(info.index) + "_" + info.param.entry;
  for (char &letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter)))
      letter = '_';
  return name;
}

/// Returns 1.1 times a quantity (a tenth of the plausible maximum if the quantity is 0), twice a count, or
/// the next allowed word. Returns "" for any other entry, so that the test fails.
std::string another_value(const StudyEntry &entry)
{
  if (entry.quantity != nullptr)
    return to_text(*entry.quantity != 0 || !entry.plausible ? 1.1 * *entry.quantity
                                                            : entry.plausible->second / 10);
  const EntryValue present = entry.value();
  if (const auto *count = std::get_if<unsigned int>(&present))
    return std::to_string(std::max(1u, 2 * *count));
  const std::regex between(", | or ");
  const std::vector<std::string> words(
    std::sregex_token_iterator(entry.allowed.begin(), entry.allowed.end(), between, -1), {});
  const auto place = std::find(words.begin(), words.end(), entry.text());
  return place == words.end() ? "" : place + 1 == words.end() ? words.front() : *(place + 1);
}

/// Returns the list `effects`, and for every other entry one effect on the terminal spin, in the first base
/// study in which the entry has an effect.
std::vector<Effect> all_effects()
{
  std::vector<Effect> all = effects;
  const test::ScratchFolder unused;
  for (const EntryValues &base :
       { EntryValues(), foot, elastic, rough, stribeck, two_way, filled, given_moment, solid })
    for (const StudyEntry &entry : entries_of(study_of({ "", "", "", base }, false, unused)))
    {
      const auto is_of_it = [&](const Effect &effect) { return effect.entry == entry.path(); };
      if (entry.has_effect && std::none_of(all.begin(), all.end(), is_of_it))
        all.push_back({ entry.path(), another_value(entry), "/ring/omega_terminal", base });
    }
  return all;
}

INSTANTIATE_TEST_SUITE_P(List, EntryEffects, testing::ValuesIn(all_effects()), name_of);

TEST(EntryEffectsList, CoversEveryEntry)
{
  std::set<std::string> tried, existing;
  for (const Effect &effect : all_effects())
    tried.insert(effect.entry);
  Study study = test::mat_study();
  for (const StudyEntry &entry : study_entries(study))
    existing.insert(entry.path());
  EXPECT_EQ(tried, existing);
}

} // namespace
} // namespace stemware::pipeline
