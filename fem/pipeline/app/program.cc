#include "fem/pipeline/app/program.h"

#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/interruption.h"
#include "fem/pipeline/support/ranks.h"

#include <CLI/CLI.hpp>

namespace stemware::pipeline
{

int run_program(int argc, char *argv[])
{
  open_missing_streams();
  watch_for_interruption();
  const MpiSession mpi;
  try
  {
    // 1. What is to be done? Each verb declares its options, examples and work.
    CLI::App program("Stemware: what the elasticity of a wine glass's foot does to its spin on a table.",
                     "stemware");
    Verb chosen;
    describe_program(program);
#define STEMWARE_VERB(name) add_##name##_verb(program, chosen);
    STEMWARE_VERBS(STEMWARE_VERB)
    if (const auto exit_code = parse_command_line(program, argc, argv))
    {
      require_printed();
      return static_cast<int>(*exit_code);
    }

    // 2. Do it.
    chosen();
    require_printed();
    return static_cast<int>(ExitCode::success);
  }
  catch (...)
  {
    // 3. Whatever goes wrong ends in one sentence and an exit code that says what kind of trouble it was.
    return static_cast<int>(report_failure());
  }
}

} // namespace stemware::pipeline
