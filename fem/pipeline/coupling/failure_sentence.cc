#include "fem/pipeline/coupling/failure_sentence.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/study/study_entries.h"
#include "ring_model/failures.h"

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

struct Failure
{
  std::string sentence;
  ExitCode code = ExitCode::numerical_failure;
  bool is_everywhere =
    false; ///< true if all ranks fail alike; if false, the other ranks wait and must be aborted
};

/// Returns the failure of the exception that is being handled.
Failure present_failure()
{
  try
  {
    throw;
  }
  catch (const BadInput &failure)
  {
    return { failure.what(), ExitCode::bad_input, true };
  }
  catch (const OutputFailure &failure)
  {
    return { failure.what(), ExitCode::output_failure, true };
  }
  catch (const fem::ContactFailure &failure)
  {
    const bool tips = failure.outcome == fem::ContactOutcome::tipping;
    return { tips ? "The glass tips: " + failure.message
                  : "No contact solution: " + with_entries(failure.what()),
             tips ? ExitCode::bad_input : ExitCode::numerical_failure, true };
  }
  catch (const ring::NoBalance &failure)
  {
    return { failure.what(), failure.tips() ? ExitCode::bad_input : ExitCode::numerical_failure, true };
  }
  catch (const std::filesystem::filesystem_error &failure)
  {
    return { failure.path1().string() + " cannot be made, read or written (" + failure.code().message() +
               "); free some space, or choose another folder with --output.",
             ExitCode::output_failure };
  }
  catch (const std::bad_alloc &)
  {
    return { "The study does not fit into this machine's memory; use fewer cells or Contact/Degree = 1." };
  }
  catch (const dealii::ExceptionBase &failure)
  {
    std::ostringstream information;
    failure.print_info(information);
    return { "deal.II stopped: " + std::string(failure.get_exc_name()) + " " + information.str() };
  }
  catch (const std::exception &failure)
  {
    return { failure.what() };
  }
}

std::string closed(const std::string &sentence)
{
  const std::string line = on_one_line(sentence);
  const bool is_closed = !line.empty() && (line.back() == '.' || line.back() == '?' || line.back() == ')');
  return is_closed ? line : line + ".";
}

} // namespace

std::string failure_sentence()
{
  return closed(present_failure().sentence);
}

ExitCode report_failure()
{
  const Failure failure = present_failure();
  if (is_first_rank() || !failure.is_everywhere)
  {
    std::cout << std::flush;
    std::cerr << "stemware: " << closed(failure.sentence) << std::endl;
  }
  if (n_ranks() > 1 && !failure.is_everywhere)
    abort_all_ranks(static_cast<int>(failure.code));
  return failure.code;
}

} // namespace stemware::pipeline
