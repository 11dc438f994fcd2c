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
#include <sstream>
#include <unistd.h>
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

SolidFoot crowned_foot(const std::string &folder, const std::string &problem = "crowned")
{
  SolidSetup setup;
  setup.table.interface = std::make_shared<WinklerInterface>(1e11);
  setup.friction_coefficient = 0.2;
  setup.checkpoint_folder = folder;
  setup.problem = problem;
  return SolidFoot(generate_solid_mesh(setup.profile, { 24, 2, 1, 1 }), setup);
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

TEST(Checkpoint, IsOfItsOwnProblemOnly)
{
  const CheckpointFolder folder;
  solve_and_stop(folder.name, 2);
  EXPECT_FALSE(fs::is_empty(folder.name));
  EXPECT_EQ(crowned_foot(folder.name, "another").solve(load_at(1.3), { -10, {} }).history.front().number, 1u);
  solve_and_stop(folder.name, 2);
  EXPECT_EQ(crowned_foot(folder.name).solve(load_at(1.2), { -10, {} }).history.front().number, 1u);
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
  EXPECT_EQ(crowned_foot(folder.name).solve(load_at(1.3), { -10, {} }).history.front().number, 1u);
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
