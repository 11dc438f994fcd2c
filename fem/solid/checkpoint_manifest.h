#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stemware::fem
{

/// Manifest of a checkpoint's folder, a text file of its own: whose the folder is, and which of the two files
/// of each rank, state_0.<rank> and state_1.<rank>, holds the last state. Nothing else in the folder is ever
/// written or removed.
struct CheckpointManifest
{
  struct File
  {
    std::uint64_t n_bytes = 0, sum = 0; ///< sum: check_sum_of()
  };

  std::uint64_t owner = 0; ///< check sum of the study that is run
  std::uint64_t solve = 0; ///< of all that the solve depends on
  unsigned long n_ranks = 1;
  unsigned long state = 0;      ///< number of the last whole state, in the files state_<number % 2>; 0: none
  unsigned long n_unknowns = 0; ///< of the mesh that it is of
  std::vector<File> files;      ///< of the last whole state, by rank
};

/// Name of the file in the folder.
extern const char *const checkpoint_manifest_name;

std::string manifest_text(const CheckpointManifest &manifest);

/// The manifest in @p text; nothing where the text is no whole manifest of this version.
std::optional<CheckpointManifest> checkpoint_manifest_in(const std::string &text);

/// CRC-64 of ECMA-182.
std::uint64_t check_sum_of(const std::string &bytes);

} // namespace stemware::fem
