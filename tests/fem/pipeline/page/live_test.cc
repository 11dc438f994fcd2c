#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/page/explore_api.h"
#include "fem/pipeline/page/explore_page.h"
#include "fem/pipeline/page/explorer.h"
#include "fem/pipeline/study/study_entries.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/answer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

using Values = std::vector<std::pair<std::string, std::string>>;

Study study_of(const Values &values)
{
  Study study;
  for (const auto &[path, value] : values)
    assign(study_entries(study), "", path, value);
  return study;
}

/// Initialises the solver of the page with the entries @p values and the compliances @p bodies.
void open_page(const Values &values,
               const std::pair<fem::ContactCompliance, std::optional<fem::ContactCompliance>> &bodies)
{
  explore_begin();
  for (const auto &[path, value] : values)
    EXPECT_STREQ(explore_set(path.c_str(), value.c_str()), "{}");
  explore_take(serialized(bodies.first).data(), 0);
  if (bodies.second)
    explore_take(serialized(*bodies.second).data(), 1);
  explore_ready(1);
}

nlohmann::json solved(unsigned int n_harmonics = 0, bool cold = true)
{
  return nlohmann::json::parse(explore_solve(n_harmonics, cold));
}

double omega_of(const nlohmann::json &answer, const char *row = "ring")
{
  return answer.at("document").at("summary").at(row).at("omega_terminal").get<double>();
}

double spin_by_the_program(const Study &study, unsigned int n_harmonics = all_harmonics)
{
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, foot_maker(cache));
  return ring::answer(find_load(study, foot, silent_progress(), n_harmonics), spin_question(study))
    .terminal->omega;
}

/// Changes one entry of @p base at a time and compares the terminal spins of page (cold start) and program.
/// @p fit: expected match of the page's mesh.
void expect_the_programs_spins(const Values &base, const Values &moves, const std::string &fit)
{
  fem::ComplianceCache cache;
  open_page(base, live_bodies(study_of(base), cache));
  EXPECT_NEAR(omega_of(solved()), spin_by_the_program(study_of(base)), 1e-10);
  for (const auto &[path, value] : moves)
  {
    Study before = study_of(base);
    const std::string text = entry_at(study_entries(before), "", path).text();
    EXPECT_STREQ(explore_set(path.c_str(), value.c_str()), "{}") << path;
    const nlohmann::json answer = solved();
    Values moved = base;
    moved.emplace_back(path, value);
    ASSERT_EQ(answer.value("error", ""), "") << path;
    EXPECT_EQ(answer["fit"], fit) << path;
    EXPECT_NEAR(omega_of(answer), spin_by_the_program(study_of(moved)), 1e-10) << path << " = " << value;
    EXPECT_STREQ(explore_set(path.c_str(), text.c_str()), "{}") << path;
  }
}

const Values hard = { { "Table/Interface", "hard" }, { "Table/Substrate", "rigid" } },
             mat = { { "Table/Interface", "Winkler" }, { "Table/Substrate", "rigid" } };
const Values bare_wood = { { "Table/Interface", "hard" }, { "Table/Substrate", "elastic" } };

TEST(Live, SpinAgreesWithTheProgramForTwentyChangedEntries)
{
  expect_the_programs_spins(mat,
                            { { "Motion/Friction coefficient", "0.2" },
                              { "Motion/Orbit speed", "25 cm/s" },
                              { "Motion/Hand height", "50 mm" },
                              { "Motion/Hand height", "10 mm" },
                              { "Motion/Mass", "200 g" },
                              { "Motion/Centre of mass height", "0.1" },
                              { "Motion/Orbit radius", "0.2" },
                              { "Motion/Orbit sense", "clockwise" },
                              { "Motion/Yaw inertia", "5e-4" },
                              { "Motion/Closure", "hand" },
                              { "Motion/Tilt", "neglected" },
                              { "Motion/Grip torque", "1e-3" },
                              { "Motion/Friction law", "Stribeck" },
                              { "Glass/Crown radius", "6 mm" },
                              { "Glass/Young modulus", "60 GPa" },
                              { "Table/Foundation modulus", "1e11" },
                              { "Contact/Friction coupling", "none" },
                              { "Contact/Rings", "3" },
                              { "Contact/Load harmonics", "12" },
                              { "Load/Coupling", "one-way" } },
                            "same");
}

TEST(Live, AgreesWithTheProgramOnHardAndElasticTables)
{
  expect_the_programs_spins(hard, { { "Motion/Friction coefficient", "0.2" } }, "same");
  expect_the_programs_spins(bare_wood, { { "Motion/Force offset", "-30 mm" } }, "same");
}

TEST(Live, AgreesWithTheProgramOnRoughTables)
{
  expect_the_programs_spins({ { "Table/Interface", "rough" }, { "Table/Substrate", "elastic" } },
                            { { "Motion/Friction coefficient", "0.2" },
                              { "Table/Reference pressure", "5e8" },
                              { "Table/Decay length", "1.1e-6" } },
                            "same");
}

TEST(Live, AgreesWithinTheStatedBandOnACloseMesh)
{
  for (const Values &base : { hard, bare_wood })
  {
    fem::ComplianceCache cache;
    open_page(base, live_bodies(study_of(base), cache));
    for (const auto &[path, value, back] :
         { std::array{ "Motion/Mass", "0.2", "0.3" }, std::array{ "Motion/Mass", "0.6", "0.3" },
           std::array{ "Glass/Crown radius", "1.5e-3", "3e-3" },
           std::array{ "Glass/Crown radius", "6e-3", "3e-3" } })
    {
      EXPECT_STREQ(explore_set(path, value), "{}");
      const nlohmann::json answer = solved();
      Values moved = base;
      moved.emplace_back(path, value);
      ASSERT_EQ(answer["fit"], "near") << path << " = " << value;
      const double spin = spin_by_the_program(study_of(moved)), error = omega_of(answer) - spin;
      EXPECT_LT(std::abs(error), close_mesh_band) << path << " = " << value;
      EXPECT_STREQ(explore_set(path, back), "{}");
    }
  }
}

TEST(Live, SpinOfASimilarFootAgreesWithTheProgram)
{
  const double ratio = 1.1;
  fem::ComplianceCache cache;
  for (const Values &table : { Values(), bare_wood, mat, Values({ { "Table/Disc thickness", "0.006" } }) })
  {
    Study larger = study_of(table);
    for (const StudyEntry &entry : study_entries(larger))
      if (entry.section == "Glass" && entry.unit == "m" && entry.quantity && entry.name != "Crown radius")
        *entry.quantity *= ratio;
    const auto bodies = live_bodies(study_of(table), cache, ratio);
    open_page(table, bodies);
    EXPECT_STREQ(explore_set("Glass/Contact radius", "0.033"), "{}");
    EXPECT_NEAR(omega_of(solved()), spin_by_the_program(larger), close_mesh_band);
  }
}

TEST(Live, AgreesWithTheProgramForOneAndTwoHarmonics)
{
  fem::ComplianceCache cache;
  open_page({}, live_bodies(Study(), cache));
  for (const unsigned int n : { 1u, 2u })
    EXPECT_NEAR(omega_of(solved(n), "first_n"), spin_by_the_program(Study(), n), 1e-9) << n;
}

TEST(Live, WarmStartsAgreeWithColdStarts)
{
  fem::ComplianceCache cache;
  const auto bodies = live_bodies(Study(), cache);
  struct Moves
  {
    const char *path;
    std::vector<const char *> values;
  };
  // The changes are small, backward or large. With 5e-3 N m, the grip holds the glass.
  for (const auto &[path, values] :
       { Moves{ "Motion/Friction coefficient", { "0.29", "0.27", "0.35", "0.36", "0.37", "0.36", "0.2" } },
         Moves{ "Motion/Force offset", { "-0.048", "-0.046", "-0.044", "-0.042" } },
         Moves{ "Motion/Orbit speed", { "0.36", "0.37", "0.38", "0.25" } },
         Moves{ "Motion/Grip torque", { "1e-3", "2e-3", "3e-3", "5e-3", "1e-3" } },
         Moves{ "Glass/Crown radius", { "3.1e-3", "3.2e-3", "3.4e-3" } } })
  {
    open_page({}, bodies);
    solved(1);
    std::vector<std::pair<double, double>> live;
    const auto spins = [](const nlohmann::json &answer)
    { return std::pair(omega_of(answer), omega_of(answer, "first_n")); };
    for (const char *const value : values)
    {
      EXPECT_STREQ(explore_set(path, value), "{}");
      live.push_back(spins(solved(1, false)));
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      explore_set(path, values[i]);
      const auto [all, first_n] = spins(solved(1, true));
      EXPECT_NEAR(live[i].first, all, 1e-7) << path << " = " << values[i];
      EXPECT_NEAR(live[i].second, first_n, 1e-7) << path << " = " << values[i];
    }
  }
}

TEST(Live, WarmStartOmitsTheLoadAtRest)
{
  fem::ComplianceCache cache;
  open_page({}, live_bodies(Study(), cache));
  solved();
  explore_set("Motion/Friction coefficient", "0.31");
  const nlohmann::json answer = solved(0, false);
  const nlohmann::json &document = answer["document"];
  EXPECT_TRUE(document["summary"]["ring"]["tau_at_rest"].is_null());
  EXPECT_TRUE(document["summary"].contains("load_at_terminal"));
  EXPECT_EQ(document["tables"]["motion"].size(), 1u);
}

TEST(Live, RefusesChangesThatNeedAnotherMeshOrMoreCompliances)
{
  fem::ComplianceCache cache;
  const auto bodies = live_bodies(study_of(mat), cache);
  open_page(mat, bodies);
  const auto refusal = [](const char *path, const char *value)
  {
    const auto reply = nlohmann::json::parse(explore_set(path, value));
    return reply.value("error", "") + solved().value("error", "");
  };
  EXPECT_NE(refusal("Glass/Foot thickness", "5 mm").find("another mesh"), std::string::npos);
  EXPECT_NE(refusal("Table/Foundation modulus", "1e14").find("width"), std::string::npos);
  open_page(hard, live_bodies(study_of(hard), cache));
  EXPECT_NE(refusal("Motion/Mass", "1 kg").find("width"), std::string::npos);

  // The compliances `narrow` cover a part of the land, and the contact reaches the border of this part.
  auto narrow = bodies;
  narrow.first = bodies.first.part(6, 5);
  open_page(mat, narrow);
  EXPECT_NE(solved().value("error", "").find("leaves the part of the land"), std::string::npos);
}

TEST(Live, ReportsTippingAtRestAndDuringTheSpinUp)
{
  fem::ComplianceCache cache;
  open_page({}, live_bodies(Study(), cache));
  explore_set("Motion/Force offset", "300 mm"); // the glass tips at rest
  EXPECT_TRUE(solved().value("tips", false));
  explore_set("Motion/Force offset", "-50 mm");
  explore_set("Motion/Centre of mass height", "138 mm"); // the glass tips during the spin-up
  EXPECT_FALSE(solved()["document"]["summary"]["ring"]["fall"].is_null());
}

TEST(Live, CurvesBudgetAndMotionAgreeWithTheAnswer)
{
  fem::ComplianceCache cache;
  open_page({}, live_bodies(Study(), cache));
  const double omega = omega_of(solved(1));
  const auto tables = [](const char *reply) { return nlohmann::json::parse(reply)["document"]["tables"]; };
  const auto column = [](const nlohmann::json &table, const std::string &key)
  {
    const auto &keys = table["keys"];
    return table["values"][static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin())];
  };
  const nlohmann::json curves = tables(explore_curves());
  EXPECT_NEAR(column(curves["spin_up"], "all").back().get<double>(), omega, 0.02 * std::abs(omega));
  EXPECT_EQ(column(curves["torque"], "up_to_1").size(), column(curves["torque"], "omega").size());
  const nlohmann::json budget = tables(explore_budget());
  EXPECT_NEAR(budget["waterfall"].back()["omega_terminal"].get<double>(), omega, 1e-9);
  EXPECT_GT(tables(explore_pressure())["foot"]["footprint"]["theta"].size(), 60u);
  // The drawn motion begins at rest and ends with less than 2 % of the initial torque.
  const nlohmann::json &motion = curves["motion"];
  EXPECT_EQ(motion[0]["omega"], 0);
  EXPECT_NEAR(motion.back()["omega"].get<double>(), omega, 0.006 * std::abs(omega));
  EXPECT_LT(motion.back()["torque"].get<double>() / motion[0]["torque"].get<double>(), 0.02);
  // The page chooses the end of the curves after the answer.
  explore_set("Motion/End time", "3.5");
  EXPECT_EQ(column(tables(explore_curves())["spin_up"], "time").back(), 3.5);
}

TEST(Live, FrictionAtRestIntegratesToTorqueAndForce)
{
  // Reference: trapezoidal rule over the points of the rim, exact for the harmonics at rest. Without tilt and
  // grip, only friction contributes to the torque.
  fem::ComplianceCache cache;
  open_page({ { "Motion/Tilt", "neglected" } }, live_bodies(Study(), cache));
  solved();
  const nlohmann::json rest = nlohmann::json::parse(explore_curves())["document"]["tables"]["motion"][0];
  const Study study = study_of({ { "Motion/Tilt", "neglected" } });
  const ring::Motion &motion = study.motion.orbit;
  double torque = 0, force = 0;
  const nlohmann::json &friction = rest["friction"];
  const auto n = friction[0].size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const double theta = 2 * ring::pi * static_cast<double>(i) / static_cast<double>(n);
    torque += friction[1][i].get<double>() * std::cos(theta) - friction[0][i].get<double>() * std::sin(theta);
    force += friction[0][i].get<double>();
  }
  const double mean = motion.friction_at_rest() * motion.normal_force() / static_cast<double>(n);
  EXPECT_NEAR(torque * mean * study.glass.profile.contact_radius, rest["torque"].get<double>(),
              0.01 * std::abs(rest["torque"].get<double>())); // the load acts close to the contact radius
  EXPECT_NEAR(force * mean, -rest["hand"][0].get<double>(), 1e-3 * std::abs(force * mean));
}

} // namespace

} // namespace stemware::pipeline
