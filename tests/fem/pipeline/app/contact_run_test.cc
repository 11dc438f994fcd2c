#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <thread>

namespace stemware::test
{
namespace
{

nlohmann::json run(const ScratchFolder &scratch, const std::vector<std::string> &settings,
                   const std::string &results = "results")
{
  return solved(scratch, { "run", scratch.write("coarse.prm", coarse_study()), "--quick" }, settings,
                results);
}

/// Returns the harmonics of the load divided by a_0, cosines followed by sines.
std::vector<double> relative_harmonics(const nlohmann::json &summary)
{
  std::vector<double> harmonics;
  for (const char *family : { "a", "b" })
    for (const auto &value : summary["load"][family])
      harmonics.push_back(value.get<double>() / summary["load"]["a"][0].get<double>());
  return harmonics;
}

void expect_same_harmonics(const nlohmann::json &one, const nlohmann::json &other, double tolerance)
{
  const auto first = relative_harmonics(one);
  const auto second = relative_harmonics(other);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_NEAR(first[i], second[i], tolerance) << i;
}

TEST(ContactRun, RepeatedRunsWriteEqualFiles)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("coarse.prm", coarse_study());
  solved(scratch, { "run", study }, { "Glass/Crown radius=0.00312345678" }, "one");
  // After more than one second, time stamps in the files would differ.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  solved(scratch, { "run", study }, { "Glass/Crown radius=0.00312345678" }, "other");
  const auto one = all_files(scratch / "one"), other = all_files(scratch / "other");
  ASSERT_EQ(one.size(), other.size());
  for (const auto &[name, text] : one)
  {
    ASSERT_EQ(other.count(name), 1u) << name;
    EXPECT_TRUE(other.at(name) == text) << name << " differs";
  }
  solved(scratch, { "run", "one/parameters.prm" }, {}, "echo");
  EXPECT_EQ(read_text(scratch / "echo/summary.json"), one.at("summary.json"));
}

TEST(ContactRun, ARunWithTheWrittenLoadFileGivesTheSameLoadAndTruncation)
{
  const ScratchFolder scratch;
  const auto contact = run(scratch, { "Contact/Rings=1" }, "contact"); // a load file has one ring
  const auto ring = run(scratch, { "Load/Source=file", "Load/File=contact/harmonics.dat" }, "ring");
  EXPECT_EQ(ring["load"]["a"], contact["load"]["a"]);
  EXPECT_EQ(ring["load"]["b"], contact["load"]["b"]);
  EXPECT_EQ(ring["truncation"], contact["truncation"]);
}

TEST(ContactRun, ResultsDoNotDependOnTheUnits)
{
  const ScratchFolder scratch;
  // The same glass in the consistent units t, mm, s, N and MPa.
  const std::vector<std::string> in_millimetres = {
    "Motion/Mass=3e-4",         "Motion/Yaw inertia=0.3",      "Motion/Centre of mass height=80",
    "Motion/Force offset=-50",  "Motion/Orbit radius=150",     "Motion/Orbit speed=350",
    "Motion/Gravity=9810",      "Glass/Contact radius=30",     "Glass/Foot radius=34",
    "Glass/Foot thickness=4",   "Glass/Land width=4",          "Glass/Land height=1",
    "Glass/Crown radius=3",     "Glass/Stem radius=5",         "Glass/Stem height=10",
    "Glass/Young modulus=70e3", "Table/Foundation modulus=10",
  };
  for (const char *table : { "Table/Interface=Winkler", "Table/Interface=hard" })
  {
    const auto metres = run(scratch, { table });
    auto settings = in_millimetres;
    settings.push_back(table);
    const auto millimetres = run(scratch, settings);
    expect_same_harmonics(metres, millimetres, 1e-8);
    const double omega = metres["ring"]["omega_terminal"];
    EXPECT_NEAR(millimetres["ring"]["omega_terminal"].get<double>(), omega, 1e-8 * std::abs(omega)) << table;
    EXPECT_NEAR(millimetres["load"]["ring_radius"].get<double>(),
                1e3 * metres["load"]["ring_radius"].get<double>(), 1e-6);
  }
}

TEST(ContactRun, AnOvalMeshGivesHigherHarmonicsAndSpinRippleAndARoundMeshDoesNot)
{
  const ScratchFolder scratch;
  const auto flat = run(scratch, { "Contact/Mesh file=" STEMWARE_MESHES "/flat_foot.msh" });
  EXPECT_TRUE(flat["contact"]["mesh"]["round_rim"].get<bool>());
  EXPECT_NEAR(flat["contact"]["mesh"]["rim_radius"].get<double>(), 0.03, 1e-8);
  // A flat land on a mat has no harmonics above the first.
  const auto harmonics = relative_harmonics(flat);
  const std::size_t n_all = flat["load"]["a"].size();
  for (std::size_t n = 2; n <= 8; ++n)
    EXPECT_LE(std::hypot(harmonics[n], harmonics[n_all + n]), 1e-5) << n;

  const auto oval = run(scratch, { "Contact/Mesh file=" STEMWARE_MESHES "/oval_foot.msh" });
  EXPECT_FALSE(oval["contact"]["mesh"]["round_rim"].get<bool>());
  EXPECT_TRUE(oval["ring"]["phase_dependent"].get<bool>()); // the oval foot rotates relative to the moment
  EXPECT_FALSE(flat["ring"]["phase_dependent"].get<bool>());
  EXPECT_GT(oval["ring"]["spin_ripple"].get<double>(), 0);
  EXPECT_GT(oval["contact"]["mesh"]["land_area_deficit"].get<double>(), 0);
  EXPECT_GT(std::abs(oval["load"]["a"][2].get<double>()), 1e-3 * oval["load"]["a"][0].get<double>());

  EXPECT_EQ(solved(scratch, { "run", "results/parameters.prm", "--quick" }, {}, "again")["load"],
            oval["load"]);
}

/// Writes the mesh of a plate of 80 mm x 40 mm, scaled from the 2 m square plate. Returns the settings of a
/// rigid plate with the load at @p eccentricity [m] in the direction @p angle [deg].
std::vector<std::string> plate_settings(const ScratchFolder &scratch, double eccentricity, double angle)
{
  std::istringstream square(read_text(STEMWARE_MESHES "/square_plate.msh"));
  std::ostringstream plate;
  bool in_nodes = false;
  for (std::string line; std::getline(square, line);)
  {
    in_nodes = line == "$Nodes" || (in_nodes && line != "$EndNodes");
    std::istringstream words(line);
    unsigned int node = 0;
    double x = 0, y = 0, z = 0;
    if (in_nodes && words >> node >> x >> y >> z)
      plate << node << ' ' << 0.04 * x << ' ' << 0.02 * y << ' ' << 0.02 * z << '\n';
    else
      plate << line << '\n';
  }
  // Mean of the smallest and largest distance of the border from the centre [m].
  const double radius = (0.02 + std::hypot(0.04, 0.02)) / 2;
  const auto text = [](double value) { return fmt::format(FMT_STRING("{:.12g}"), value); };
  return { "Contact/Mesh file=" + scratch.write("plate.msh", plate.str()),
           "Contact/Degree=1",
           "Contact/Friction coupling=none",
           "Glass/Contact radius=" + text(radius),
           "Glass/Young modulus=1e14",
           "Table/Foundation modulus=1e9",
           "Motion/Yaw inertia=1e-4",
           "Load/Moment ratio=" + text(2 * eccentricity / radius),
           "Load/Moment direction=" + text(angle) + " deg" };
}

TEST(ContactRun, RimRadiusAndContactOfAPlateAgreeWithClosedForms)
{
  const ScratchFolder scratch;
  // The load is outside the kern of L/6 = 13.3 mm, so the contact length is 3 (L/2 - e) = 66 mm.
  const auto summary = run(scratch, plate_settings(scratch, 0.018, 90));
  EXPECT_NEAR(summary["contact"]["mesh"]["rim_radius"].get<double>(), (0.02 + std::hypot(0.04, 0.02)) / 2,
              1e-12);
  EXPECT_FALSE(summary["contact"]["mesh"]["round_rim"].get<bool>());
  EXPECT_EQ(summary["contact"]["mesh"]["land_area_deficit"].get<double>(), 0);
  EXPECT_NEAR(summary["load"]["contact_fraction"].get<double>(), 3 * 0.022 / 0.08, 1e-3);
  EXPECT_NEAR(summary["load"]["peak_pressure"].get<double>() / (2 * 2.943 / (3 * 0.022 * 0.04)), 1, 1e-3);
}

TEST(ContactRun, ReportsAGlassThatTipsOnASoftMatAndWritesNoFiles)
{
  const ScratchFolder scratch;
  const Ended ended =
    stemware(scratch, { "run", "--quick", "--set", "Motion/Tilt=included", "--set",
                        "Motion/Centre of mass height=0.14", "--set", "Motion/Force offset=-0.05", "--set",
                        "Table/Interface=Winkler", "--set", "Table/Substrate=rigid", "--set",
                        "Table/Foundation modulus=1e8" });
  EXPECT_EQ(ended.exit_code, 1) << ended.out;
  EXPECT_EQ(ended.err.rfind("stemware: The glass tips: ", 0), 0u) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{});
}

TEST(ContactRun, TwoRanksGiveTheResultsOfOneRankAndWriteTheirFieldsInTwoPieces)
{
  const ScratchFolder scratch;
  const auto alone = run(scratch, {}, "alone");
  const Ended ended = RunningProgram({ STEMWARE_MPIRUN, "-n", "2", STEMWARE_PROGRAM, "run", "coarse.prm",
                                       "--quick", "--output", "together" },
                                     scratch.path())
                        .end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "alone", "coarse.prm", "together" }));
  expect_same_harmonics(alone, read_summary(scratch / "together"), 1e-9);
  // Only the first rank may print.
  EXPECT_EQ(ended.out.find("Results"), ended.out.rfind("Results"));
  // Each rank writes the fields of its cells; the report lists only the .pvtu file.
  const std::vector<std::string> pieces = { "contact_0.vtu", "contact_1.vtu" };
  EXPECT_EQ(names_in(scratch / "together/fields"),
            (std::vector<std::string>{ "contact.pvtu", pieces[0], pieces[1] }));
  const auto n_cells = [&](const std::string &file)
  {
    const std::string text = read_text(scratch / file), count = "NumberOfCells=\"";
    return std::stoi(text.substr(text.find(count) + count.size()));
  };
  for (const std::string &piece : pieces)
    EXPECT_GT(n_cells("together/fields/" + piece), 0);
  EXPECT_EQ(n_cells("together/fields/" + pieces[0]) + n_cells("together/fields/" + pieces[1]),
            n_cells("alone/fields/contact.vtu"));
  const nlohmann::json page = page_document(scratch / "together"),
                       page_of_one = page_document(scratch / "alone");
  EXPECT_THAT(page["files"].dump(), testing::HasSubstr("fields/contact.pvtu"));
  EXPECT_THAT(page["files"].dump(), testing::Not(testing::HasSubstr("fields/contact.vtu")));
  const auto tables_of = [](const nlohmann::json &document)
  {
    std::set<std::string> names;
    for (const auto &[name, table] : document["tables"].items())
      names.insert(name);
    for (const auto &[name, part] : document["tables"]["foot"].items())
      names.insert("foot/" + name + (part.is_null() ? ": none" : ""));
    return names;
  };
  EXPECT_EQ(tables_of(page), tables_of(page_of_one));
}

TEST(ContactRun, ARankThatCannotWriteEndsAllRanks)
{
  const ScratchFolder scratch;
  scratch.write("coarse.prm", coarse_study());
  // A file size limit makes the second rank fail when its fields are written. The ranks communicate by TCP,
  // because shared memory would need a file above the limit.
  const std::string command = std::string("[ \"$OMPI_COMM_WORLD_RANK\" = 0 ] || ulimit -f 4; exec ") +
                              STEMWARE_PROGRAM + " run coarse.prm --quick";
  const Ended ended = RunningProgram({ STEMWARE_MPIRUN, "--mca", "btl", "self,tcp", "--mca",
                                       "btl_tcp_if_include", "lo", "-n", "2", "/bin/sh", "-c", command },
                                     scratch.path())
                        .end();
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  const std::string sentence = "stemware: The file contact_1.vtu cannot be written";
  EXPECT_THAT(ended.err, testing::HasSubstr(sentence));
  EXPECT_EQ(ended.err.find(sentence), ended.err.rfind(sentence)) << ended.err;
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "coarse.prm" });
}

} // namespace
} // namespace stemware::test
