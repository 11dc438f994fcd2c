#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// The JSON of @p text, which may come from anywhere. Throws BadInput with one sentence, which begins with
/// @p origin, where it is broken (with line and column), nested deeper than any file of a study, or has two
/// values of one name.
nlohmann::ordered_json parse_json(const std::string &origin, const std::string &text);

/// The JSON of a text that the program itself has written: nothing where it is broken.
std::optional<nlohmann::ordered_json> json_in(const std::string &text);

/// A JSON object as the text of a file that carries a check sum of its own, as its last key "crc64": for
/// results that differ between equal runs.
std::string sealed_text(nlohmann::ordered_json object);

/// Whether @p text is such a file, as it was written.
bool is_sealed(const std::string &text);

/// CRC-64 of @p bytes (ECMA-182, as xz has it), 16 hexadecimal digits.
std::string check_sum(const std::string &bytes);

} // namespace stemware::pipeline
