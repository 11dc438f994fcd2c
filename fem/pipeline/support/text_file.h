#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Writes a whole file; throws OutputFailure, with one sentence, unless every byte has been taken by the
/// disk.
void write_text_file(const std::filesystem::path &file, const std::string &text);

/// All bytes of a file; nothing of one that cannot be read.
std::string read_text_file(const std::filesystem::path &file);

/// Throws BadInput with one sentence, which begins with @p setting ("Load/File = my.dat"), unless @p file is
/// there and is no folder, pipe or device.
void require_regular_file(const std::string &setting, const std::filesystem::path &file);

/// @p text without the byte order mark that editors of Windows put before it. Throws BadInput with one
/// sentence, which begins with @p origin, where that says UTF-16.
std::string without_byte_order_mark(const std::string &origin, std::string text);

/// Reads the text of a file of at most 16 MB, without a byte order mark. Throws BadInput with one sentence,
/// which begins with @p setting, for anything that is no such file.
std::string read_input_text(const std::string &setting, const std::filesystem::path &file);

/// A line of a text file.
struct TextLine
{
  std::string text;        ///< without blanks at its ends; not empty
  unsigned int number = 0; ///< counted from 1
};

/// Returns the lines of read_input_text() that are not empty.
std::vector<TextLine> read_lines(const std::string &setting, const std::filesystem::path &file);

} // namespace stemware::pipeline
