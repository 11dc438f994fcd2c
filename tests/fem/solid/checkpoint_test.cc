// A contact solve that is stopped anywhere and begun again goes on from its checkpoint, to the same digits.
#include "fem/contact/hard_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/solid/solid_foot.h"
#include "tests/fem/reference_load.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace stemware::fem_tests;
namespace fs = std::filesystem;

namespace
{

/// A folder for the test; of all ranks, whose first names it.
struct CheckpointFolder
{
  CheckpointFolder()
  {
    int number = static_cast<int>(getpid());
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    name = testing::TempDir() + "stemware_checkpoint_test_" + std::to_string(number);
  }
  ~CheckpointFolder()
  {
    std::error_code ignored;
    MPI_Barrier(MPI_COMM_WORLD);
    fs::remove_all(name, ignored);
  }
  std::string name;
};

SolidFoot crowned_foot(const std::string &folder, const std::string &problem = "crowned",
                       const FootResolution &resolution = { 12, 2, 1, 1 })
{
  SolidSetup setup;
  setup.table.interface = std::make_shared<WinklerInterface>(1e11);
  setup.friction_coefficient = 0.2;
  setup.checkpoint_folder = folder;
  setup.problem = problem;
  return SolidFoot(generate_solid_mesh(setup.profile, resolution), setup);
}

struct Stopped
{
};

/// Begins the solve and stops it after @p n_steps on the finest mesh.
void solve_and_stop(const std::string &folder, unsigned int n_steps)
{
  SolidFoot foot = crowned_foot(folder);
  EXPECT_THROW(foot.solve(load_at(1.3), { -10, {} },
                          [&](const ContactIteration &step)
                          {
                            if (step.number == n_steps)
                              throw Stopped();
                          }),
               Stopped);
}

/// Of few cells, halved @p refinements times.
SolidFoot small_foot(unsigned int refinements, const std::string &folder = "")
{
  return crowned_foot(folder, "small", { 12, 2, 1, refinements });
}

/// What the checkpoint in @p folder says of itself: number of the state, unknowns of its mesh.
std::pair<unsigned long, unsigned long> latest_state(const std::string &folder)
{
  std::ifstream file(fs::path(folder) / "latest");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    lines.push_back(line);
  return { std::stoul(lines.at(lines.size() - 2)), std::stoul(lines.back()) };
}

/// Lets the last rank fail to save state @p number in @p folder, while it lives; the other ranks can.
struct Obstacle
{
  Obstacle(const std::string &folder, unsigned int number)
      : place(fs::path(folder) /
              ("state_" + std::to_string(number) + "." +
               std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1)))
  {
    fs::create_directories(place / "in the way");
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~Obstacle()
  {
    std::error_code ignored;
    MPI_Barrier(MPI_COMM_WORLD);
    fs::remove_all(place, ignored);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  fs::path place;
};

} // namespace

TEST(Checkpoint, AStoppedSolveGoesOnToTheSameDigits)
{
  const CheckpointFolder folder;
  const ContactState whole = crowned_foot("").solve(load_at(1.3), { -10, {} });
  ASSERT_GE(whole.history.size(), 3u);
  for (const unsigned int n_steps : { 1u, 2u })
  {
    solve_and_stop(folder.name, n_steps);
    const ContactState state = crowned_foot(folder.name).solve(load_at(1.3), { -10, {} });
    EXPECT_EQ(state.history.front().number, n_steps + 1); // no step is taken twice
    EXPECT_EQ(state.solution.n_iterations, whole.solution.n_iterations);
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_EQ(state.load.a[0][n], whole.load.a[0][n]) << n;
      EXPECT_EQ(state.load.b[0][n], whole.load.b[0][n]) << n;
    }
    EXPECT_TRUE(fs::is_empty(folder.name)); // a finished solve leaves nothing
  }
}

TEST(Checkpoint, ASolveWhoseStatesOneRankCannotSaveStopsOnAllAndGoesOn)
{
  const CheckpointFolder folder;
  const ContactState whole = small_foot(1).solve(load_at(1.3), { -10, {} });
  std::set<unsigned long> meshes; // of the states that were saved, by their unknowns
  std::optional<ContactState> state;
  for (unsigned int number = 2; !state && number < 50; number += 3)
  {
    const Obstacle obstacle(folder.name, number);
    try
    {
      state = small_foot(1, folder.name).solve(load_at(1.3), { -10, {} });
    }
    catch (const std::runtime_error &error)
    {
      ASSERT_EQ(error.what(), "The checkpoint in " + folder.name +
                                " cannot be written; make room, or leave Contact/Checkpoint folder empty.");
      const auto [saved, n_unknowns] = latest_state(folder.name);
      ASSERT_EQ(saved, number - 1);
      meshes.insert(n_unknowns);
    }
  }
  ASSERT_TRUE(state);
  for (const unsigned int refinements : { 0u, 1u }) // stopped on every mesh
    EXPECT_TRUE(meshes.count(small_foot(refinements).description().n_unknowns)) << refinements;
  EXPECT_EQ(state->solution.n_iterations, whole.solution.n_iterations);
  for (unsigned int n = 0; n <= 8; ++n)
  {
    EXPECT_EQ(state->load.a[0][n], whole.load.a[0][n]) << n;
    EXPECT_EQ(state->load.b[0][n], whole.load.b[0][n]) << n;
  }
}

TEST(Checkpoint, IsOfItsOwnProblemOnly)
{
  const CheckpointFolder folder;
  solve_and_stop(folder.name, 2);
  EXPECT_FALSE(fs::is_empty(folder.name));
  EXPECT_EQ(crowned_foot(folder.name, "another").solve(load_at(1.3), { -10, {} }).history.front().number, 1u);
  EXPECT_TRUE(fs::is_empty(folder.name));
  solve_and_stop(folder.name, 2);
  EXPECT_EQ(crowned_foot(folder.name).solve(load_at(1.2), { -10, {} }).history.front().number, 1u);
  EXPECT_TRUE(fs::is_empty(folder.name));
}

TEST(Checkpoint, OfAnotherVersionIsNotUsed)
{
  const CheckpointFolder folder;
  solve_and_stop(folder.name, 2);
  // What is said of the state is that of an older program, what is in it is not.
  const fs::path latest = fs::path(folder.name) / "latest";
  std::ostringstream content;
  content << std::ifstream(latest).rdbuf();
  const std::string present = "stemware checkpoint 2\n", text = content.str();
  ASSERT_EQ(text.substr(0, present.size()), present);
  std::ofstream(latest) << "stemware checkpoint 1\n" << text.substr(present.size());
  // Left by a longer solve, and by one that was killed while it wrote; a file of another program.
  for (const char *name : { "state_1000.0", "state_1001.1.unfinished", "state_of_the_table.txt" })
    std::ofstream(fs::path(folder.name) / name) << "old";
  EXPECT_EQ(crowned_foot(folder.name).solve(load_at(1.3), { -10, {} }).history.front().number, 1u);
  EXPECT_TRUE(fs::remove(fs::path(folder.name) / "state_of_the_table.txt"));
  EXPECT_TRUE(fs::is_empty(folder.name));
}

TEST(Checkpoint, CutShortLongerOrWithoutItsStateIsSaid)
{
  const auto cut_to_100 = [](const fs::path &file) { fs::resize_file(file, 100); };
  const auto cut_by_1 = [](const fs::path &file) { fs::resize_file(file, fs::file_size(file) - 1); };
  const auto longer_by_1 = [](const fs::path &file) { fs::resize_file(file, fs::file_size(file) + 1); };
  const auto removed = [](const fs::path &file) { fs::remove(file); };
  for (const std::function<void(const fs::path &)> &damage :
       std::vector<std::function<void(const fs::path &)>>{ cut_to_100, cut_by_1, longer_by_1, removed })
  {
    const CheckpointFolder folder;
    solve_and_stop(folder.name, 1);
    for (const auto &item : fs::directory_iterator(folder.name))
      if (item.path().filename() != "latest")
        damage(item.path());
    SolidFoot foot = crowned_foot(folder.name);
    try
    {
      foot.solve(load_at(1.3), { -10, {} });
      ADD_FAILURE() << "a damaged checkpoint was used";
    }
    catch (const std::runtime_error &error)
    {
      EXPECT_EQ(error.what(), "The checkpoint in " + folder.name + " is damaged; remove it to begin anew.");
    }
  }
}

TEST(Checkpoint, IsRefusedWhereThereIsNone)
{
  const CheckpointFolder folder;
  SolidSetup direct;
  direct.checkpoint_folder = folder.name;
  direct.table.interface = std::make_shared<HardInterface>();
  EXPECT_THROW(SolidFoot(generate_solid_mesh(direct.profile, { 12, 2, 1 }), direct), std::invalid_argument);
}
