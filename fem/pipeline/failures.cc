#include "fem/pipeline/failures.h"

#include "fem/contact_driver.h"
#include "fem/pipeline/ranks.h"

#include <deal.II/base/exceptions.h>

#include <iostream>
#include <new>
#include <sstream>

namespace stemware::pipeline
{

std::string on_one_line(const std::string &text)
{
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

namespace
{

void print(const std::string &sentence)
{
  const std::string line = on_one_line(sentence);
  const bool closed = !line.empty() && (line.back() == '.' || line.back() == '?' || line.back() == ')');
  std::cout << std::flush;
  std::cerr << "stemware: " << line << (closed ? "" : ".") << std::endl;
}

/// A failure that all ranks have met.
ExitCode everywhere(const std::string &sentence, ExitCode code)
{
  if (is_first_rank())
    print(sentence);
  return code;
}

/// A failure that the other ranks may not know of: they would wait for this one for ever.
ExitCode perhaps_here_only(const std::string &sentence)
{
  print(sentence);
  if (n_ranks() > 1)
    abort_all_ranks(static_cast<int>(ExitCode::numerical_failure));
  return ExitCode::numerical_failure;
}

} // namespace

ExitCode report_failure()
{
  try
  {
    throw;
  }
  catch (const BadInput &failure)
  {
    return everywhere(failure.what(), ExitCode::bad_input);
  }
  catch (const OutputFailure &failure)
  {
    return everywhere(failure.what(), ExitCode::output_failure);
  }
  catch (const fem::ContactFailure &failure)
  {
    return everywhere(std::string("No contact solution: ") + failure.what(), ExitCode::numerical_failure);
  }
  catch (const std::bad_alloc &)
  {
    return perhaps_here_only(
      "The study does not fit into this machine's memory; use fewer cells or Contact/Degree = 1.");
  }
  catch (const dealii::ExceptionBase &failure)
  {
    std::ostringstream information;
    failure.print_info(information);
    return perhaps_here_only("deal.II stopped: " + std::string(failure.get_exc_name()) + " " +
                             information.str());
  }
  catch (const std::exception &failure)
  {
    return perhaps_here_only(failure.what());
  }
}

} // namespace stemware::pipeline
