// MPI is initialised only for solid feet, so other feet do not need Slurm's PMI.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware
{
namespace
{

using namespace test;

/// Runs the program with the environment of a Slurm job step. Open MPI lacks Slurm's PMI, so MPI_Init() would
/// end the process if the program did not hide the job step (open-mpi issue 10286).
Ended in_slurm_step(const ScratchFolder &scratch, const std::vector<std::string> &arguments)
{
  std::vector<std::string> command = { "/usr/bin/env" };
  for (const char *setting :
       { "SLURM_JOB_ID=134", "SLURM_JOBID=134", "SLURM_STEP_ID=0", "SLURM_STEPID=0", "SLURM_NTASKS=1",
         "SLURM_NPROCS=1", "SLURM_PROCID=0", "SLURM_LOCALID=0", "SLURM_NODEID=0", "SLURM_NNODES=1",
         "SLURM_NODELIST=n1", "SLURM_TASKS_PER_NODE=1", "SLURM_STEP_NODELIST=n1", "SLURM_STEP_NUM_NODES=1",
         "SLURM_STEP_NUM_TASKS=1", "SLURM_STEP_TASKS_PER_NODE=1" })
    command.push_back(setting);
  command.push_back(STEMWARE_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunningProgram(command, scratch.path()).end();
}

TEST(SlurmStep, RunSweepAndExploreWorkInAJobStepWithoutPmi)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  for (const std::vector<std::string> &arguments :
       { std::vector<std::string>{ "run", study, "--quick", "--output", "run" },
         { "sweep", study, "--vary", "Motion/Orbit speed=0.3:0.35:2", "--output", "sweep" },
         { "explore", study, "--output", "page.html" } })
  {
    const Ended ended = in_slurm_step(scratch, arguments);
    EXPECT_EQ(ended.exit_code, 0) << arguments.front() << ": " << ended.err;
  }
}

TEST(SlurmStep, ARunOfASolidFootWorksInAJobStepWithoutPmi)
{
  const ScratchFolder scratch;
  const Ended ended = in_slurm_step(
    scratch, { "run", scratch.write("study.prm", coarse_study()), "--quick", "--output", "results" });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

} // namespace
} // namespace stemware
