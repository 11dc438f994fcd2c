#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Writes a file. Throws OutputFailure unless the disk has accepted every byte.
void write_text_file(const std::filesystem::path &file, const std::string &text);

/// Returns all bytes of a file; empty if it cannot be read.
std::string read_text_file(const std::filesystem::path &file);

/// Throws BadInput, beginning with @p setting ("Load/File = my.dat"), unless @p file is a regular file.
void require_regular_file(const std::string &setting, const std::filesystem::path &file);

/// Returns @p text without a UTF-8 byte order mark. Throws BadInput, naming @p origin, for a UTF-16 mark.
std::string without_byte_order_mark(const std::string &origin, std::string text);

/// Reads a text file of at most 16 MB without byte order mark. Throws BadInput, naming @p setting, otherwise.
std::string read_input_text(const std::string &setting, const std::filesystem::path &file);

/// Returns the folders of installed files: ../share/stemware (installed program) and share/stemware (build
/// tree), relative to the folder of the executable. Empty if that folder is unknown.
std::vector<std::filesystem::path> shared_folders();

/// Files compiled into the program, name and text, in the order given to stemware_compiled_in() of
/// CMakeLists.txt.
using CompiledTexts = std::vector<std::pair<std::string, std::string>>;

/// Returns the text of the file @p name. Throws std::logic_error if it is not compiled in.
const std::string &text_of(const CompiledTexts &files, const std::string &name);

} // namespace stemware::pipeline
