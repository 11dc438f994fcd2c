#pragma once

#include <stdexcept>
#include <string>

namespace stemware::pipeline
{

/// Exit status of the program.
enum class ExitCode : int
{
  success = 0,
  bad_input = 1,         ///< usage, study file, mesh file, load file
  numerical_failure = 2, ///< no contact solution, no terminal spin, out of memory
  output_failure = 3     ///< the results cannot be written
};

/// Something that the user gave is not allowed; what() is one sentence: what was given, what is allowed, what
/// to do.
class BadInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The results cannot be written; what() is one sentence.
class OutputFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws BadInput with @p sentence unless @p condition holds.
void require(bool condition, const std::string &sentence);

/// Runs of white space and control characters, line ends included, as single blanks: multi-line messages of
/// other libraries on one line.
std::string on_one_line(const std::string &text);

/// Quotes a given text for a message: on one line, and at most @p longest characters of it,
/// "..." after that.
std::string shortened(const std::string &text, std::size_t longest = 80);

/// Quotes a given path for a message: on one line, and the last 80 characters of it at most,
/// because its end says most.
std::string shortened_path(const std::string &path);

} // namespace stemware::pipeline
