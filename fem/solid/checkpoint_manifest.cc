#include "fem/solid/checkpoint_manifest.h"

#include <boost/crc.hpp>

#include <sstream>

namespace stemware::fem
{

const char *const checkpoint_manifest_name = "latest";

namespace
{

constexpr char first_line[] = "stemware checkpoint 3\n";

} // namespace

std::uint64_t check_sum_of(const std::string &bytes)
{
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::string manifest_text(const CheckpointManifest &manifest)
{
  std::ostringstream text;
  text << first_line << "study " << manifest.owner << "\nsolve " << manifest.solve << "\nranks "
       << manifest.n_ranks << "\nstate " << manifest.state << "\nunknowns " << manifest.n_unknowns << '\n';
  for (const CheckpointManifest::File &file : manifest.files)
    text << "file " << file.n_bytes << ' ' << file.sum << '\n';
  text << "end\n";
  return text.str();
}

std::optional<CheckpointManifest> checkpoint_manifest_in(const std::string &text)
{
  const std::string head = first_line;
  if (text.compare(0, head.size(), head) != 0)
    return std::nullopt;
  CheckpointManifest manifest;
  std::istringstream stream(text.substr(head.size()));
  std::string word;
  const auto read = [&](const char *name, auto &number) { return stream >> word >> number && word == name; };
  if (!read("study", manifest.owner) || !read("solve", manifest.solve) || !read("ranks", manifest.n_ranks) ||
      !read("state", manifest.state) || !read("unknowns", manifest.n_unknowns))
    return std::nullopt;
  while (stream >> word && word == "file")
  {
    CheckpointManifest::File file;
    if (!(stream >> file.n_bytes >> file.sum))
      return std::nullopt;
    manifest.files.push_back(file);
  }
  // Equal manifests have equal texts: what is not as it was written is none.
  const bool is_whole = manifest.files.size() == (manifest.state > 0 ? manifest.n_ranks : 0);
  return is_whole && manifest_text(manifest) == text ? std::optional(manifest) : std::nullopt;
}

} // namespace stemware::fem
