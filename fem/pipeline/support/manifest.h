#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Name of the file in which a folder of results lists its files, so that nothing else is ever replaced or
/// removed: {"program": "stemware", "files": {"load.dat": {"bytes": 123, "crc64": "..."}, ...}}. Files in
/// folders below are listed by their relative path, the manifest itself is not.
extern const char *const manifest_name;

/// Writes the manifest of all files that are in @p folder now. Files of sealed_text() are listed without size
/// and check sum, so that equal runs have equal manifests. Throws OutputFailure,
/// std::filesystem::filesystem_error.
void write_manifest(const std::filesystem::path &folder);

/// Obstacle to replacing @p folder, as the end of a sentence that begins with the folder: "holds
/// figures/note.txt, which is not a result of Stemware". Nothing where the folder is empty, or holds only
/// files that its manifest lists, each as it was written. Links are not followed. Throws
/// std::filesystem::filesystem_error.
std::optional<std::string> why_not_replaceable(const std::filesystem::path &folder);

/// Whether @p folder has a manifest of Stemware, whatever else is in it.
bool has_manifest(const std::filesystem::path &folder);

/// Removes the files that the manifest of @p folder lists and that are as it lists them, then the manifest,
/// and the folders that are empty after that. Anything else stays.
void remove_listed_files(const std::filesystem::path &folder) noexcept;

/// A JSON object as the text of a file that carries a check sum of its own, as its last key "crc64": for
/// results that differ between equal runs.
std::string sealed_text(nlohmann::ordered_json object);

/// CRC-64 of @p bytes (ECMA-182, as xz has it), 16 hexadecimal digits.
std::string check_sum(const std::string &bytes);

} // namespace stemware::pipeline
