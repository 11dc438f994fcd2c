#include "fem/pipeline/support/text_file.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/folders.h"

#include <boost/algorithm/string/trim.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// Makes a new file, which must not be there, not even as a link; the results' own folder is nobody else's,
/// so that there @p is_new may be false.
int open_file(const std::filesystem::path &file, bool is_new)
{
  return ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (is_new ? O_EXCL : O_TRUNC), 0666);
}

/// write_all() to a file that was just opened, which is closed.
bool write_and_close(int descriptor, const std::string &text)
{
  if (descriptor < 0)
    return false;
  const bool is_written = write_all(descriptor, text);
  const int error = errno;
  const bool is_closed = ::close(descriptor) == 0;
  if (!is_written)
    errno = error;
  return is_written && is_closed;
}

} // namespace

bool write_all(int descriptor, const std::string &text)
{
  for (std::size_t n_written = 0; n_written < text.size();)
  {
    const auto n = ::write(descriptor, text.data() + n_written, text.size() - n_written);
    if (n >= 0)
      n_written += static_cast<std::size_t>(n);
    else if (errno != EINTR)
      return false;
  }
  return true;
}

void write_text_file(const std::filesystem::path &file, const std::string &text)
{
  if (!write_and_close(open_file(file, false), text))
    throw OutputFailure(fmt::format(FMT_STRING("The file {} of the results cannot be written ({}); make "
                                               "room, or choose another folder with --output."),
                                    file.filename().string(), std::strerror(errno)));
}

void replace_text_file(const std::filesystem::path &file, const std::string &text)
{
  std::filesystem::path partial = file;
  partial.replace_filename("." + file.filename().string() + ".partial-" + unique_suffix());
  const auto refuse = [&](const std::string &reason)
  {
    throw OutputFailure(fmt::format(FMT_STRING("The file {} cannot be written ({}); choose another place."),
                                    file.string(), reason));
  };
  const int descriptor = open_file(partial, true);
  if (descriptor < 0)
    refuse(std::strerror(errno));
  std::error_code error;
  if (!write_and_close(descriptor, text))
    error = std::error_code(errno, std::generic_category());
  else
    std::filesystem::rename(partial, file, error);
  if (!error)
    return;
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);
  refuse(error.message());
}

void require_no_file(const std::filesystem::path &file)
{
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, error)))
    throw OutputFailure("The file " + shortened_path(file.string()) +
                        " exists already and is not overwritten; give another name, or remove it.");
}

void create_text_file(const std::filesystem::path &file, const std::string &text)
{
  const std::string the_file = "The file " + shortened_path(file.string());
  const int descriptor = open_file(file, true);
  if (descriptor < 0 && errno == EEXIST)
    require_no_file(file);
  if (write_and_close(descriptor, text))
    return;
  const std::string reason = std::strerror(errno);
  std::error_code ignored;
  if (descriptor >= 0)
    std::filesystem::remove(file, ignored);
  throw OutputFailure(the_file + " cannot be written (" + reason + "); choose another place.");
}

std::string read_text_file(const std::filesystem::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void require_regular_file(const std::string &setting, const std::filesystem::path &file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  require(std::filesystem::exists(status), setting +
                                             " does not exist; give a path that starts at the study "
                                             "file (on the command line: where the program is started).");
  require(std::filesystem::is_regular_file(status), setting + " is not a file; give the path of a file.");
}

std::string without_byte_order_mark(const std::string &origin, std::string text)
{
  require(text.compare(0, 2, "\xFF\xFE") != 0 && text.compare(0, 2, "\xFE\xFF") != 0,
          origin + " is in UTF-16, two bytes a letter; save it as UTF-8.");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
    text.erase(0, 3);
  return text;
}

std::vector<TextLine> read_lines(const std::string &setting, const std::filesystem::path &file)
{
  constexpr std::uintmax_t most_bytes = 16000000;
  require_regular_file(setting, file);
  std::ifstream stream(file);
  require(static_cast<bool>(stream), setting + " cannot be read; check its permissions.");
  require(std::filesystem::file_size(file) <= most_bytes,
          setting + " is larger than 16 MB; leave out rows, or name the right file.");
  std::vector<TextLine> lines;
  std::string text;
  for (unsigned int number = 1; std::getline(stream, text); ++number)
  {
    if (number == 1)
      text = without_byte_order_mark(setting, text);
    boost::trim(text);
    if (!text.empty())
      lines.push_back({ text, number });
  }
  return lines;
}

} // namespace stemware::pipeline
