// A contact solve that is stopped anywhere and begun again goes on from its checkpoint, to the same digits.
#include "fem/contact/hard_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/solid/contact_checkpoint.h"
#include "fem/solid/solid_foot.h"
#include "tests/fem/reference_load.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <sys/resource.h>
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
  EXPECT_THROW(foot.solve(load_at(1.3), { -10, {} }, {},
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

std::string text_of(const fs::path &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What the checkpoint in @p folder says of itself.
CheckpointManifest manifest_in(const std::string &folder)
{
  return checkpoint_manifest_in(text_of(fs::path(folder) / checkpoint_manifest_name)).value();
}

/// Lets the last rank fail to write more than so many bytes into a file, while it lives; the other ranks can.
struct SmallDisk
{
  explicit SmallDisk(rlim_t n_bytes)
  {
    getrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_IGN);
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) + 1 != n_ranks)
      return;
    const rlimit small = { n_bytes, before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &before); }
  rlimit before;
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
    const std::string saved = text_of(fs::path(folder.name) / checkpoint_manifest_name);
    const ContactState state =
      crowned_foot(folder.name)
        .solve(load_at(1.3), { -10, {} }, {},
               [&](const ContactIteration &step)
               {
                 // No step is taken twice: nothing is saved before the first new one.
                 if (step.number <= n_steps)
                 {
                   EXPECT_EQ(text_of(fs::path(folder.name) / checkpoint_manifest_name), saved);
                 }
               });
    EXPECT_EQ(state.solution.n_iterations, whole.solution.n_iterations);
    EXPECT_EQ(state.solution.n_linear_iterations, whole.solution.n_linear_iterations);
    ASSERT_EQ(state.history.size(), whole.history.size());
    for (std::size_t i = 0; i < whole.history.size(); ++i)
    {
      EXPECT_EQ(state.history[i].number, whole.history[i].number) << i;
      EXPECT_EQ(state.history[i].n_loaded, whole.history[i].n_loaded) << i;
      EXPECT_EQ(state.history[i].n_changed, whole.history[i].n_changed) << i;
      EXPECT_EQ(state.history[i].residual, whole.history[i].residual) << i;
      EXPECT_EQ(state.history[i].step_length, whole.history[i].step_length) << i;
      EXPECT_EQ(state.history[i].linear_iterations, whole.history[i].linear_iterations) << i;
    }
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_EQ(state.load.a(n), whole.load.a(n)) << n;
      EXPECT_EQ(state.load.b(n), whole.load.b(n)) << n;
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
  for (rlim_t n_bytes = 4000; !state && n_bytes < 100000000; n_bytes *= 2)
  {
    const SmallDisk small(n_bytes);
    try
    {
      state = small_foot(1, folder.name).solve(load_at(1.3), { -10, {} });
    }
    catch (const std::runtime_error &error)
    {
      ASSERT_EQ(error.what(), "The checkpoint in " + folder.name +
                                " cannot be written; make room, or leave Contact/Checkpoint folder empty.");
      MPI_Barrier(MPI_COMM_WORLD);
      meshes.insert(manifest_in(folder.name).n_unknowns);
    }
  }
  ASSERT_TRUE(state);
  // Stopped before the first state, and between those of the two meshes.
  EXPECT_EQ(meshes, (std::set<unsigned long>{ 0, small_foot(0).description().n_unknowns }));
  EXPECT_EQ(state->solution.n_iterations, whole.solution.n_iterations);
  for (unsigned int n = 0; n <= 8; ++n)
  {
    EXPECT_EQ(state->load.a(n), whole.load.a(n)) << n;
    EXPECT_EQ(state->load.b(n), whole.load.b(n)) << n;
  }
}

TEST(Checkpoint, OfAnotherStudyIsKeptAndSaid)
{
  const CheckpointFolder folder;
  solve_and_stop(folder.name, 2);
  const auto files = [&]
  {
    std::map<std::string, std::string> texts;
    for (const auto &item : fs::directory_iterator(folder.name))
      texts[item.path().filename()] = text_of(item.path());
    return texts;
  };
  const auto before = files();
  EXPECT_EQ(before.size(), 2u);
  const auto expect_kept = [&](const std::string &owner)
  {
    try
    {
      const ContactCheckpoint other(folder.name, owner, "crowned");
      ADD_FAILURE() << "another study's folder was taken";
    }
    catch (const std::invalid_argument &error)
    {
      EXPECT_EQ(error.what(),
                "Contact/Checkpoint folder = " + folder.name +
                  " keeps the state of another study or number of ranks (1); run that one to its "
                  "end, give another folder, or delete this one.");
    }
  };
  expect_kept("another study");
  EXPECT_EQ(files(), before);
  // Another solve of the same study does not take the state away from the one whose it is.
  EXPECT_EQ(crowned_foot(folder.name).solve(load_at(1.2), { -10, {} }).history.front().number, 1u);
  EXPECT_EQ(files(), before);
  crowned_foot(folder.name).solve(load_at(1.3), { -10, {} });
  EXPECT_TRUE(fs::is_empty(folder.name));
}

TEST(Checkpoint, FilesOfTheUsersAreNeitherReadNorRemoved)
{
  const auto refusal = [](const std::string &name, const std::string &text)
  {
    const CheckpointFolder folder;
    fs::create_directories(folder.name);
    std::ofstream(fs::path(folder.name) / name) << text;
    std::string sentence;
    try
    {
      crowned_foot(folder.name).solve(load_at(1.3), { -10, {} });
    }
    catch (const std::invalid_argument &error)
    {
      sentence = error.what();
    }
    EXPECT_EQ(text_of(fs::path(folder.name) / name), text) << name;
    return sentence.substr(std::min(sentence.size(), sentence.find("holds")));
  };
  const std::string rest = "; give another folder, or move that file away.";
  EXPECT_EQ(refusal("latest", "my\n"), "holds latest, which is not of a checkpoint of this version" + rest);
  EXPECT_EQ(refusal("latest", "stemware checkpoint 2\nranks 1\n"),
            "holds latest, which is not of a checkpoint of this version" + rest);
  EXPECT_EQ(refusal("latest.unfinished", "my\n"),
            "holds latest.unfinished, which is not of a checkpoint" + rest);
  EXPECT_EQ(refusal("state_1.0", "data\n"), "holds state_1.0, which is not of a checkpoint" + rest);
  // Of other names there is no word.
  EXPECT_EQ(refusal("state_3.0", "data\n"), "");
}

TEST(Checkpoint, ThatIsNotAsItWasWrittenIsSaid)
{
  const auto cut_to_100 = [](const fs::path &file) { fs::resize_file(file, 100); };
  const auto cut_by_1 = [](const fs::path &file) { fs::resize_file(file, fs::file_size(file) - 1); };
  const auto longer_by_1 = [](const fs::path &file) { fs::resize_file(file, fs::file_size(file) + 1); };
  const auto removed = [](const fs::path &file) { fs::remove(file); };
  const auto two_bytes_flipped = [](const fs::path &file)
  {
    std::string bytes = text_of(file);
    std::swap(bytes.at(1000), bytes.at(1001));
    bytes[1000] = static_cast<char>(bytes[1000] ^ 1);
    std::ofstream(file, std::ios::binary) << bytes;
  };
  for (const std::function<void(const fs::path &)> &damage :
       std::vector<std::function<void(const fs::path &)>>{ cut_to_100, cut_by_1, longer_by_1, removed,
                                                           two_bytes_flipped })
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
