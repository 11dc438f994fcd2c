#pragma once

#include <stdexcept>
#include <string>

namespace stemware::pipeline
{

/// Exit status of the program.
enum class ExitCode : int
{
  success = 0,
  bad_input = 1,         ///< usage, study file, mesh file, load file, a glass that tips
  numerical_failure = 2, ///< no contact solution, no terminal spin, out of memory
  output_failure = 3     ///< the results cannot be written
};

/// Exception for inadmissible input; what() is one sentence: what was given, what is allowed, what to do.
class BadInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Exception for results that cannot be written; what() is one sentence.
class OutputFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws BadInput with @p sentence unless @p condition holds.
void ensure(bool condition, const std::string &sentence);

/// Returns @p text on one line: runs of white space and control characters become single blanks.
std::string on_one_line(const std::string &text);

/// Returns @p text for a message: on one line; if longer than @p longest, cut and followed by "...".
std::string shortened(const std::string &text, std::size_t longest = 80);

/// Returns @p path for a message: on one line, at most its last 80 characters.
std::string shortened_path(const std::string &path);

} // namespace stemware::pipeline
