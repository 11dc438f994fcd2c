#include "fem/pipeline/support/text_file.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/number_text.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// Whether every byte has been taken by the disk; errno says why not.
bool write_all(const std::filesystem::path &file, const std::string &text)
{
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  return static_cast<bool>(stream);
}

} // namespace

void write_text_file(const std::filesystem::path &file, const std::string &text)
{
  if (!write_all(file, text))
    throw OutputFailure("The file " + file.filename().string() + " of the results cannot be written (" +
                        std::strerror(errno) + "); make room, or choose another folder with --output.");
}

void replace_text_file(const std::filesystem::path &file, const std::string &text)
{
  std::filesystem::path partial = file;
  partial.replace_filename("." + file.filename().string() + ".partial-" + std::to_string(::getpid()));
  const auto refuse = [&](const std::string &reason)
  {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw OutputFailure("The file " + file.string() + " cannot be written (" + reason +
                        "); choose another place.");
  };
  if (!write_all(partial, text))
    refuse(std::strerror(errno));
  std::error_code error;
  if (std::filesystem::rename(partial, file, error); error)
    refuse(error.message());
}

std::string data_table(const std::string &title, const std::vector<DataColumn> &columns)
{
  std::ostringstream text;
  text << "# " << title << '\n';
  for (std::size_t c = 0; c < columns.size(); ++c)
    text << "# " << c + 1 << ": " << columns[c].name << " (" << columns[c].unit << ")\n";
  for (std::size_t row = 0; row < columns.front().values.size(); ++row)
  {
    for (const DataColumn &column : columns)
      text << std::setw(24) << to_text(column.values.at(row)) << ' ';
    text.seekp(-1, std::ios::cur);
    text << '\n';
  }
  return text.str();
}

} // namespace stemware::pipeline
