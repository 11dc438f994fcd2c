#include "fem/pipeline/program.h"
#include "fem/pipeline/verbs.h"

#include <CLI/CLI.hpp>

namespace stemware::pipeline
{

void describe_program(CLI::App &program)
{
  program.require_subcommand(1);
  program.set_version_flag("--version", "stemware " + program_version() + " (" + program_revision() + ")");
  program.set_help_flag("-h,--help", "Show this text, or that of a verb: stemware run --help");
  program.footer(R"(Examples:
  stemware run docs/cookbooks/paper.prm      the paper's glass; results in results/paper
  stemware defaults > my_glass.prm           a commented study file to start from
  stemware run my_glass.prm --set "Table/Foundation modulus=1e11"

Exit codes:
  0   done
  1   usage, or something wrong in the study, mesh or load file
  2   no solution: the contact or the spin did not converge, or memory ran out
  3   the results cannot be written
  130 interrupted; no results are left behind)");
}

std::optional<ExitCode> parse_command_line(CLI::App &program, int argc, char *argv[])
{
  try
  {
    program.parse(argc, argv);
    return std::nullopt;
  }
  catch (const CLI::Success &request)
  {
    program.exit(request);
    return ExitCode::success;
  }
  catch (const CLI::ParseError &error)
  {
    const auto verbs = program.get_subcommands();
    const auto rest = program.remaining();
    const std::string verb = verbs.empty() ? "" : verbs.front()->get_name() + " ";
    const std::string trouble = !verbs.empty() ? on_one_line(error.what())
                                : rest.empty() ? "say what to do, run or defaults"
                                               : "\"" + rest.front() + "\" is not one of run and defaults";
    std::cerr << "stemware: " << trouble << "; see `stemware " << verb << "--help` for examples."
              << std::endl;
    return ExitCode::bad_input;
  }
}

} // namespace stemware::pipeline
