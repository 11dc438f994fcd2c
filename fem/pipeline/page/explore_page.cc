#include "fem/pipeline/page/explore_page.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/page/explorer.h"
#include "fem/pipeline/page/page.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/revolution/meridian_meshes.h"

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Compliance in the compressed form of the page, which is four times smaller than compressed floats. The
/// numbers are integer multiples of a step, 2^-bits of the largest number. The change of each integer from
/// the previous harmonic is predicted by the change of the integer before it. The residual is small, because
/// compliances vary smoothly. Residuals are mapped to unsigned numbers and stored in four passes: the lowest
/// bytes of all numbers, then the next higher bytes.
class PagedCompliance
{
public:
  PagedCompliance(const fem::ContactCompliance &compliance, int bits)
      : given(serialized(compliance))
      , head(6 + compliance.n_nodes())
      , n_of_harmonic((given.size() - head) / (compliance.n_harmonics() + 2))
  {
    for (std::size_t i = head; i < given.size(); ++i)
      step = std::max(step, std::abs(given[i]));
    step = std::ldexp(step, -bits);
    for (std::size_t i = head; i < given.size(); ++i)
      given[i] = std::nearbyint(given[i] / step) * step;
  }

  /// Returns the quantised numbers in the format of fem::serialized(), as input of an Explorer.
  const double *numbers() const { return given.data(); }

  std::string bytes() const
  {
    std::string result(reinterpret_cast<const char *>(given.data()), head * sizeof(double));
    result.append(reinterpret_cast<const char *>(&step), sizeof step);
    std::vector<std::uint32_t> left;
    std::uint32_t last = 0;
    for (std::size_t i = head; i < given.size(); ++i)
    {
      // The arithmetic is modulo 2^32.
      const std::uint32_t change = whole(i) - (i < head + n_of_harmonic ? 0 : whole(i - n_of_harmonic));
      const std::uint32_t rest = change - std::exchange(last, change);
      left.push_back(rest >> 31 ? ~(rest << 1) : rest << 1);
    }
    for (unsigned int shift = 0; shift < 32; shift += 8)
      for (const std::uint32_t number : left)
        result += static_cast<char>(number >> shift & 255);
    result.resize((result.size() + 7) / 8 * 8);
    return result;
  }

private:
  std::uint32_t whole(std::size_t i) const
  {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::llround(given[i] / step)));
  }

  std::vector<double> given;
  std::size_t head, n_of_harmonic;
  double step = 0;
};

std::vector<std::string> entries_of(const Preset &preset)
{
  Study study;
  read_prm(preset.name, preset.text, study_entries(study));
  std::vector<std::string> paths;
  for (const auto &[path, text] : study.given_entries)
    paths.push_back(path);
  return paths;
}

Study study_of(const PageOptions &options, const Preset &glass, const Preset &table)
{
  Study study = options.study;
  for (const Preset *preset : { &glass, &table })
    read_prm(preset->name, preset->text, study_entries(study));
  check_study(study);
  return study;
}

/// Returns the entries that differ from the defaults, without Motion/Force offset, which follows from
/// Motion/Hand height.
std::vector<std::pair<std::string, std::string>> values_of(const std::vector<StudyEntry> &own)
{
  std::vector<std::pair<std::string, std::string>> values;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i].text() != default_entries()[i].text() && own[i].path() != "Motion/Force offset")
      values.emplace_back(own[i].path(), own[i].text());
  return values;
}

/// Returns the answer that the page will compute, by an Explorer with the quantised compliances.
ring::Answer answer_in_page(const std::vector<StudyEntry> &own, double fineness, const PagedCompliance &foot,
                            const PagedCompliance *disc)
{
  Explorer explorer;
  for (const auto &[path, value] : values_of(own))
    explorer.set(path, value);
  explorer.set_compliance(foot.numbers(), false);
  if (disc)
    explorer.set_compliance(disc->numbers(), true);
  explorer.freeze_mesh(fineness);
  return explorer.solve(all_harmonics, true).full.value();
}

/// Returns a discretisation whose focused mesh has at most @p max_nodes contact nodes; 0: no limit.
Discretisation coarsened(const Study &study, unsigned int max_nodes, fem::ComplianceCache &cache)
{
  Discretisation mesh;
  if (max_nodes == 0 || !revolution_setup(study).resolution.has_focus())
    return mesh;
  while (live_bodies({ study, mesh }, cache).first.n_nodes() > max_nodes && mesh.fineness > 0.05)
    mesh.fineness *= 0.85;
  return mesh;
}

Json buttons(const std::vector<Preset> &presets)
{
  Json list = Json::array();
  for (const Preset &preset : presets)
    list.push_back({ { "name", preset.name }, { "words", preset.words }, { "sets", entries_of(preset) } });
  return list;
}

/// Returns @p presets. If there are none, returns one without entries, which means the study's own @p part.
std::vector<Preset> selectable(const std::vector<Preset> &presets, const std::string &part)
{
  return presets.empty() ? std::vector<Preset>{ { part + " of the study", "", {}, "" } } : presets;
}

/// Maximum error of a pair's terminal spin due to quantisation [rad/s], before a slider is moved. At other
/// slider settings, the error may be ten times as large.
constexpr double tolerance = 1e-11;

/// Contact radii of additional feet on elastic tables, relative to the contact radius of the study.
constexpr double similar_feet[] = { 0.8, 0.9, 1.1, 1.2 };

/// Glass and table of a page, with the program's answer and the compliances stored in the page.
struct SolvedPair
{
  std::string glass, table;
  Study study;
  unsigned int n_nodes;
  double fineness; ///< Discretisation::fineness
  PagedCompliance foot;
  std::optional<PagedCompliance> disc;
  /// Compliances of an elastic table under feet of other sizes (`similar_feet`), by contact radius [m].
  std::map<double, PagedCompliance> discs;
  std::optional<double> omega; ///< terminal spin by `run` [rad/s]; std::nullopt if the glass tips
  std::optional<double> here;  ///< terminal spin that an Explorer computes from these compliances [rad/s]
  /// Twice the difference of the spins, if the page's mesh is coarser than that of `run` [rad/s].
  std::optional<double> band = {};
};

/// Solves a pair. Quantises its compliances with the smallest number of bits that meets `tolerance`.
SolvedPair solve_pair(const PageOptions &options, const Preset &glass, const Preset &table,
                      fem::ComplianceCache &cache)
{
  const Study study = study_of(options, glass, table);
  const ring::Answer program = [&]
  {
    const auto foot = study_foot(study, foot_maker(cache));
    return ring::answer(find_load(study, foot), spin_question(study)).value();
  }();
  const Discretisation mesh = coarsened(study, options.max_nodes, cache);
  const bool is_coarse = mesh.fineness < 1;
  const auto [of_foot, of_disc] = live_bodies({ study, mesh }, cache);
  for (int bits = is_coarse ? 20 : 24;; bits = bits < 27 ? 27 : 30)
  {
    const PagedCompliance foot(of_foot, bits);
    const auto disc = of_disc ? std::optional(PagedCompliance(*of_disc, bits)) : std::nullopt;
    const ring::Answer here = answer_in_page(entries_of(study), mesh.fineness, foot, disc ? &*disc : nullptr);
    const double error = std::abs(here.last_spin().value() - program.last_spin().value());
    if (!is_coarse && bits < 30 && error > tolerance)
      continue;
    SolvedPair pair = { glass.name, table.name, study, of_foot.n_nodes(),        mesh.fineness,
                        foot,       disc,       {},    program.omega_terminal(), here.omega_terminal() };
    if (is_coarse)
      pair.band = 2 * error;
    if (disc)
      for (const double ratio : similar_feet)
        pair.discs.emplace(ratio * study.glass.profile.contact_radius,
                           PagedCompliance(*live_bodies({ study, mesh }, cache, ratio).second, bits));
    return pair;
  }
}

std::string compressed_base64(const std::string &text)
{
  const std::string compressed = dealii::Utilities::compress(text);
  return dealii::Utilities::encode_base64({ compressed.begin(), compressed.end() });
}

std::string script_in(const std::string &page, const std::string &id)
{
  const std::string tag = "id=\"" + id + "\">";
  const std::size_t begin = page.find(tag), end = page.find("</script>", begin);
  if (begin == std::string::npos || end == std::string::npos)
    return "";
  return page.substr(begin + tag.size(), end - begin - tag.size());
}

/// Returns the installed solver as WebAssembly, gzip in base64: of explore.wasm in share/stemware, else of
/// explore.html there.
std::string live_solver()
{
  for (const std::filesystem::path &folder : shared_folders())
    if (const std::string wasm = read_text_file(folder / "explore.wasm"); !wasm.empty())
      return compressed_base64(wasm);
  for (const std::filesystem::path &folder : shared_folders())
    if (std::string wasm = script_in(read_text_file(folder / "explore.html"), "wasm"); !wasm.empty())
      return wasm;
  throw BadInput(
    "This Stemware has no solver for a page; build it with -D STEMWARE_EXPLORE=ON, or put the page "
    "explore.html of the project into share/stemware.");
}

} // namespace

std::pair<fem::ContactCompliance, std::optional<fem::ContactCompliance>>
live_bodies(const FootSpecification &specification, fem::ComplianceCache &cache, double ratio)
{
  const Study &study = specification.study;
  ensure(study.load.is_from_contact(), "A page needs a contact to solve; set Load/Source = contact.");
  ensure(study.contact.is_of_revolution(),
         "A page solves bodies of revolution only; set Contact/Body = revolution.");
  ensure(!study.has_waviness(),
         "A page solves one load over the spin; leave Glass/Rim waviness and Table/Waviness empty.");
  ensure(files_of(entries_of(study)).empty(),
         "A page reads no files; leave Glass/Profile file and Motion/Orbit speed file empty.");
  ensure(study.contact.goal == Goal::none, "A page keeps its mesh; set Contact/Goal = none.");
  fem::RevolutionSetup setup = revolution_setup(specification);
  if (setup.table.substrate)
  {
    setup.table.substrate->disc.radius /= ratio;
    setup.table.substrate->disc.thickness /= ratio;
  }
  const fem::MeridianMeshes meshes(setup);
  const fem::MeridianOptions options = setup.meridian_of_zone();
  std::optional<fem::ContactCompliance> disc;
  if (setup.table.substrate)
    disc = *cache.get(meshes.disc, setup.table.substrate->material, options);
  return { *cache.get(meshes.foot, setup.material, options), disc };
}

std::string explore_page(const PageOptions &options, fem::ComplianceCache &cache, Progress &progress)
{
  const std::string solver = live_solver();
  const std::vector<Preset> glasses = selectable(options.glasses, "glass"),
                            tables = selectable(options.tables, "table");
  std::vector<std::optional<SolvedPair>> solved(glasses.size() * tables.size());
  ThreadedExecutor(cache, options.n_threads)
    .for_each(solved.size(),
              [&](std::size_t i) {
                solved[i] = solve_pair(options, glasses[i / tables.size()], tables[i % tables.size()], cache);
              });

  std::string bodies;
  Json pairs, entries, places = Json::array();
  const auto add_body = [&](const PagedCompliance &compliance)
  {
    places.push_back(bodies.size());
    bodies += compliance.bytes();
    return places.size() - 1;
  };
  std::string spins;
  for (const std::optional<SolvedPair> &pair : solved)
  {
    const std::vector<StudyEntry> own = entries_of(pair->study);
    Json acting = Json::array(), discs = Json::array();
    for (const StudyEntry &entry : own)
      if (entry.has_effect)
        acting.push_back(entry.path());
    for (const auto &[radius, disc] : pair->discs)
      discs.push_back({ rounded(radius, 6), add_body(disc) });
    pairs[pair->glass + '|' + pair->table] = { { "values", values_of(own) },
                                               { "acts", acting },
                                               { "foot", add_body(pair->foot) },
                                               { "disc", pair->disc ? Json(add_body(*pair->disc)) : Json() },
                                               { "discs", discs },
                                               { "fineness", pair->fineness },
                                               { "nodes", pair->n_nodes },
                                               { "omega", pair->omega },
                                               { "here", pair->here },
                                               { "band", pair->band } };
    const std::string name = pair->glass + " on " + pair->table,
                      spin = pair->omega ? fmt::format(FMT_STRING("{:.4f} rad/s"), *pair->omega) : "tips";
    spins += (spins.empty() ? "" : ", ") + name + ' ' + boost::replace_all_copy(spin, "-", "\u2212");
    progress.note("Pair", fmt::format(FMT_STRING("{}: {} nodes, {}"), name, pair->n_nodes, spin) +
                            (pair->band ? fmt::format(FMT_STRING(" ± {:.1e}"), *pair->band) : ""));
  }
  for (const StudyEntry &entry : default_entries())
    entries[entry.path()] = entry.text();
  const Json data = { { "version", program_version() },
                      { "tolerance", tolerance },
                      { "near_band", close_mesh_band },
                      { "glasses", buttons(glasses) },
                      { "tables", buttons(tables) },
                      { "entries", entries },
                      { "pairs", pairs },
                      { "bodies", places } };
  return live_page(data, compressed_base64(bodies), solver, "The spinning wine glass",
                   "Terminal spins by stemware run: " + spins + '.');
}

} // namespace stemware::pipeline
