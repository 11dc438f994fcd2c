#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_run.h"
#include "tests/fem/pipeline/csv_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace stemware::pipeline
{
namespace
{

using test::CsvTable;
using test::SolvedRun;

const SolvedRun &solved_run()
{
  static const SolvedRun run(test::quick_contact_study());
  return run;
}

CsvTable file_of(const Results &results, const std::string &name)
{
  for (const ResultFile &file : results.files)
    if (file.name == name)
      return CsvTable(csv_table(std::get<Table>(file.content)));
  throw std::out_of_range("no file " + name);
}

TEST(RunResults, TruncationFileContainsTheRowsOfTheAnalysis)
{
  const SpinStudy &spin = solved_run().spin;
  const std::vector<LoadedRow> &rows = spin.rows.by_harmonics;
  const CsvTable table = file_of(solved_run().results(), "truncation.csv");
  ASSERT_EQ(table.n_rows(), rows.size());
  ASSERT_EQ(spin.torque_effects.rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const ring::Answer &row = rows[i].row;
    const ring::TorqueEffect &effect = spin.torque_effects.rows[i];
    EXPECT_EQ(table.number(i, "harmonics (1)"), row.harmonics);
    EXPECT_EQ(table.number(i, "tau_z at rest (N m)"), row.at_rest->friction.torque);
    EXPECT_EQ(table.number(i, "terminal omega (rad/s)"), row.omega_terminal());
    EXPECT_EQ(table.number(i, "least load at rest (N/rad)"), row.at_rest->minimum);
    EXPECT_EQ(table.number(i, "change of tau_z at half the terminal spin (N m)"), effect.half->change);
    EXPECT_EQ(table.number(i, "change of tau_z at the terminal spin (N m)"), effect.terminal->change);
    EXPECT_EQ(table.number(i, "largest change of tau_z from rest to the terminal spin (N m)"),
              effect.largest);
    EXPECT_EQ(table.number(i, "omega of the largest change (rad/s)"), effect.largest_at);
  }
}

TEST(RunResults, ContactFilesContainTheNumbersOfTheContact)
{
  const Results results = solved_run().results();
  const FootReport &foot = *solved_run().contact.foot;
  const CsvTable history = file_of(results, "contact_history.csv");
  ASSERT_EQ(history.n_rows(), foot.at_rest.history.size());
  for (std::size_t i = 0; i < history.n_rows(); ++i)
  {
    const fem::ContactIteration &step = foot.at_rest.history[i];
    EXPECT_EQ(history.number(i, "step (1)"), step.number);
    EXPECT_EQ(history.number(i, "loaded places (1)"), step.n_loaded);
    EXPECT_EQ(history.number(i, "changed places (1)"), step.n_changed);
    EXPECT_EQ(history.number(i, "relative imbalance of forces (1)"), step.residual);
    EXPECT_EQ(history.number(i, "share of the step taken (1)"), step.step_length);
  }
  const CsvTable footprint = file_of(results, "footprint.csv");
  std::size_t row = 0;
  for (const auto &cut : foot.footprint.cuts)
    for (const fem::PressurePoint &point : cut)
    {
      EXPECT_EQ(footprint.number(row, "r (m)"), point.radius);
      EXPECT_EQ(footprint.number(row, "theta (rad)"), point.azimuth);
      EXPECT_EQ(footprint.number(row++, "pressure (Pa)"), point.pressure);
    }
  EXPECT_EQ(footprint.n_rows(), row);
}

TEST(RunResults, RingsFileContainsEveryCoefficientOfEveryRing)
{
  const ring::RingStack &load = solved_run().contact.load;
  const CsvTable table = file_of(solved_run().results(), "rings.csv");
  std::size_t row = 0;
  for (std::size_t j = 0; j < load.rings().size(); ++j)
    for (std::size_t n = 0; n <= load.n_harmonics(); ++n, ++row)
    {
      EXPECT_EQ(table.number(row, "ring j (1)"), static_cast<double>(j + 1));
      EXPECT_EQ(table.number(row, "n (1)"), static_cast<double>(n));
      EXPECT_EQ(table.number(row, "r_j (m)"), load.radii()[j]);
      EXPECT_EQ(table.number(row, "a_n (N/rad)"), load.rings()[j].a[n]);
      EXPECT_EQ(table.number(row, "b_n (N/rad)"), load.rings()[j].b[n]);
    }
  EXPECT_EQ(table.n_rows(), row);
}

TEST(RunResults, SummaryContainsTheBudgetOfTheAnalysis)
{
  const Budget &budget = *solved_run().budget;
  const Json summary = solved_run().summary(), &rows = summary["budget"], &without = summary["without"];
  ASSERT_EQ(rows.size(), budget.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const BudgetRow &row = budget.rows[i];
    EXPECT_EQ(rows[i]["step"], label_of(row.step));
    EXPECT_EQ(rows[i]["name"], row.name);
    EXPECT_EQ(rows[i]["omega_terminal"], row.omega_terminal.value());
    EXPECT_EQ(rows[i]["difference"], row.difference ? Json(*row.difference) : Json());
    EXPECT_EQ(rows[i]["band"], row.band ? Json(*row.band) : Json());
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(rows[i]["torques"][k], row.torques[k].value());
    EXPECT_EQ(rows[i]["state"], to_string(row.status));
  }
  ASSERT_EQ(without.size(), budget.without.size());
  for (std::size_t i = 0; i < without.size(); ++i)
    EXPECT_EQ(without[i]["omega_terminal"], budget.without[i].omega_terminal.value());
  EXPECT_EQ(summary["harmonic_effect"]["relative"], harmonic_effect(solved_run().spin.rows).relative.value());
  EXPECT_EQ(summary["torque_effect"]["largest"],
            solved_run().spin.torque_effects.rows.back().largest.value());
}

TEST(RunResults, SummaryContainsTheClosedFormOfTheTorqueAtRest)
{
  const SolvedRun &run = solved_run();
  EXPECT_NEAR(run.summary()["ring"]["tau_closed_form"].get<double>(),
              run.study.motion.orbit.friction_coefficient * run.contact.load.moment().x(), 1e-12);
}

TEST(RunResults, NoLiftOffRequiresFullContactAndANonnegativeLoad)
{
  StudyAnswer run = solved_run();
  run.bands = {};
  ContactReport &report = run.contact;
  const auto decided = [&] { return run_results(run).summary["ring"]["no_lift_off"].get<bool>(); };
  for (LoadReport *load : { &report.load, &report.load_at_end })
  {
    load->contact_fraction = 1;
    load->least = 0.1;
  }
  EXPECT_TRUE(decided());
  report.load.least = -1e-3; // tensile load
  EXPECT_FALSE(decided());
  report.load.least = 0;
  EXPECT_TRUE(decided());
  report.load_at_end.contact_fraction = 0.99;
  EXPECT_FALSE(decided());
}

TEST(RunResults, OmitTheContactIfTheStudySolvesNone)
{
  StudyAnswer run = solved_run();
  run.bands = {};
  run.contact.foot.reset();
  run.contact.coupling.reset();
  const Results without = run_results(run);
  for (const char *key : { "contact", "coupling" })
    EXPECT_TRUE(without.summary[key].is_null()) << key;
  EXPECT_THROW(file_of(without, "contact_history.csv"), std::out_of_range);
  EXPECT_FALSE(without.tables.contains("contact"));
}

TEST(RunResults, SummaryContainsTheGoalOfTheMesh)
{
  StudyAnswer run = solved_run();
  run.study.contact.goal = Goal::terminal_spin;
  run.study.contact.goal_tolerance = 2e-5;
  GoalOutcome outcome;
  outcome.value = -3.5;
  outcome.estimated_error = 3e-5;
  outcome.n_meshes = 4;
  outcome.n_cells = 1000;
  run.goal = outcome;
  run.bands[index_of(run.bands, "omega_terminal")].parts["mesh"] = 6e-5;
  const Json goal = run_results(run).summary["goal"];
  EXPECT_EQ(goal["name"], "terminal spin");
  EXPECT_EQ(goal["value"], -3.5);
  EXPECT_EQ(goal["estimated_error"], 3e-5);
  EXPECT_EQ(goal["band_of_mesh"], 6e-5);
  EXPECT_EQ(goal["tolerance"], 2e-5);
  EXPECT_EQ(goal["meshes"], 4);
  EXPECT_EQ(goal["cells"], 1000);
  EXPECT_FALSE(solved_run().summary().contains("goal"));
}

TEST(TruncationResults, ReportTheNumberOfHarmonicsForAToleranceAndTheReasonOfAFailedRow)
{
  StudyAnswer run = solved_run();
  std::vector<LoadedRow> &rows = run.spin.rows.by_harmonics;
  rows.erase(rows.begin(), rows.end() - 3);
  ring::TorqueEffects &effects = run.spin.torque_effects;
  effects.rows.erase(effects.rows.begin(), effects.rows.end() - 3);
  rows[0].row.relative_change = 2e-2;
  rows[1].row = {};
  rows[1].row.harmonics = effects.rows[1].harmonics;
  rows[1].row.reason = "No balance of moments was found";
  rows[2].row.relative_change = 0;
  const Results results = truncation_results(run);
  EXPECT_EQ(results.key_figures["harmonics_for_1e-4"], rows[2].row.harmonics);
  EXPECT_EQ(results.summary["truncation"][1]["message"], rows[1].row.reason);
}

const std::vector<BudgetRow> budget_rows = { { { 1 }, "paper", 1, -3. },
                                             { { 3 }, "where the foot touches", 1, -3.4, -0.4 },
                                             { { 4 }, "harmonics", 2, -3.2, 0.2 },
                                             { { 5 }, "harmonics", 3, -3.3, -0.1 },
                                             { { 6 }, "harmonics", {}, -3.25, 0.05 } };

TEST(BudgetTable, OmitsHarmonicsWithoutEffectButNotTheCompleteModel)
{
  std::vector<BudgetRow> rows = budget_rows;
  rows[3].difference = 1e-13;
  const std::vector<BudgetRow> shown = shown_chain(rows, 1e-9);
  ASSERT_EQ(shown.size(), rows.size() - 1);
  // The difference refers to the previous shown row.
  EXPECT_NEAR(shown.back().difference.value(), -3.25 + 3.2, 1e-14);
  rows.back().difference = 0; // the complete model is always shown
  EXPECT_EQ(shown_chain(rows, 1e-9).size(), rows.size() - 1);
}

TEST(BudgetTable, OmitsOnlyPercentagesRelativeToAGlassAtRest)
{
  std::vector<BudgetRow> rows = budget_rows;
  rows[0].omega_terminal = 0;
  rows[1].difference = rows[1].omega_terminal;
  const Table table = chain_fields().table(rows, Face::page);
  const auto column =
    std::find_if(table.columns.begin(), table.columns.end(),
                 [](const Column &one) { return one.quantity.key == "relative_difference"; });
  ASSERT_NE(column, table.columns.end());
  EXPECT_TRUE(column->cells[0].is_null());
  EXPECT_TRUE(column->cells[1].is_null());
  EXPECT_FALSE(column->cells[2].is_null());
}

TEST(BudgetTable, CombinesAllHarmonicsInOneNamedStep)
{
  const std::vector<BudgetRow> rows = named_steps(budget_rows);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(title_of(rows[2]), "harmonics, all");
  EXPECT_NEAR(rows[2].difference.value(), -3.25 + 3.4, 1e-14);
  std::vector<BudgetRow> with_a_failure = budget_rows;
  with_a_failure[2].difference.reset();
  EXPECT_FALSE(named_steps(with_a_failure).back().difference);
}

} // namespace
} // namespace stemware::pipeline
