#include "fem/pipeline/base/text_file.h"

#include "fem/pipeline/base/failures.h"

#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

void write_text_file(const fs::path &file, const std::string &text)
{
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close(); // fails too if the file was not opened
  if (!stream)
    throw OutputFailure(fmt::format(
      FMT_STRING(
        "The file {} cannot be written ({}); free some space, or choose another place with --output."),
      file.filename().string(), std::generic_category().message(errno)));
}

std::string read_text_file(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void require_regular_file(const std::string &setting, const fs::path &file)
{
  std::error_code error;
  const auto status = fs::status(file, error);
  ensure(fs::exists(status), setting + " does not exist; give a path that starts at the study file (on the "
                                       "command line: where the program is started).");
  ensure(fs::is_regular_file(status), setting + " is not a file; give the path of a file.");
}

std::string without_byte_order_mark(const std::string &origin, std::string text)
{
  ensure(text.compare(0, 2, "\xFF\xFE") != 0 && text.compare(0, 2, "\xFE\xFF") != 0,
         origin + " is in UTF-16, two bytes a letter; save it as UTF-8.");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
    text.erase(0, 3);
  return text;
}

std::string read_input_text(const std::string &setting, const fs::path &file)
{
  constexpr std::uintmax_t max_bytes = 16000000;
  require_regular_file(setting, file);
  ensure(static_cast<bool>(std::ifstream(file)), setting + " cannot be read; check its permissions.");
  ensure(fs::file_size(file) <= max_bytes,
         setting + " is larger than 16 MB; leave out rows, or name the right file.");
  return without_byte_order_mark(setting, read_text_file(file));
}

std::vector<std::filesystem::path> shared_folders()
{
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  const std::filesystem::path folder = program.parent_path();
  return { folder.parent_path() / "share/stemware", folder / "share/stemware" };
}

const std::string &text_of(const CompiledTexts &files, const std::string &name)
{
  for (const auto &[file, text] : files)
    if (file == name)
      return text;
  throw std::logic_error("The program has no text " + name + ".");
}

} // namespace stemware::pipeline
