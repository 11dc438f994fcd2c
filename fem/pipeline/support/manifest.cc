#include "fem/pipeline/support/manifest.h"

#include "fem/pipeline/support/folders.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const char *const manifest_name = "manifest.json";

namespace
{

constexpr char seal[] = "crc64";

bool is_sealed(const std::string &text)
{
  std::optional<Json> object = json_in(text);
  if (!object || !object->is_object() || !object->contains(seal))
    return false;
  object->erase(seal);
  return sealed_text(*object) == text;
}

/// How the manifest describes a file with that content.
Json description_of(const std::string &content)
{
  if (is_sealed(content))
    return { { "sealed", true } };
  return { { "bytes", content.size() }, { "crc64", check_sum(content) } };
}

/// The files that the manifest of @p folder lists; nothing where there is no manifest of ours.
std::optional<Json> listed_files(const fs::path &folder)
{
  const fs::path file = folder / manifest_name;
  if (!is_plain_file(file))
    return std::nullopt;
  const std::optional<Json> manifest = json_in(read_text_file(file));
  if (!manifest || !manifest->is_object() || manifest->value("program", Json()) != "stemware" ||
      !manifest->value("files", Json()).is_object())
    return std::nullopt;
  return (*manifest)["files"];
}

/// All that is in a folder and the folders in it, by relative path, sorted: a folder comes before what is in
/// it.
std::vector<std::string> tree_of(const fs::path &folder)
{
  std::vector<std::string> paths;
  for (const auto &item : fs::recursive_directory_iterator(folder)) // follows no links
    paths.push_back(item.path().lexically_relative(folder));
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Whether a folder is one in which files are listed, as "figures" is where figures/load.svg is.
bool is_listed_folder(const std::string &name, const Json &files)
{
  for (const auto &item : files.items())
    if (item.key().compare(0, name.size() + 1, name + '/') == 0)
      return true;
  return false;
}

/// Whether a file is as the manifest lists it.
bool is_as_listed(const fs::path &folder, const std::string &name, const Json &files)
{
  return files.contains(name) && is_plain_file(folder / name) &&
         description_of(read_text_file(folder / name)) == files[name];
}

/// Whether this is what version 0.1 has written, which kept no manifest.
bool is_older_summary(const fs::path &file)
{
  if (!is_plain_file(file))
    return false;
  const std::optional<Json> summary = json_in(read_text_file(file));
  return summary && summary->is_object() && summary->contains("schema") && summary->contains("program") &&
         summary->contains("files");
}

} // namespace

std::string check_sum(const std::string &bytes)
{
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return fmt::format(FMT_STRING("{:016x}"), crc.checksum());
}

std::string sealed_text(Json object)
{
  object[seal] = check_sum(object.dump());
  return object.dump(2) + "\n";
}

void write_manifest(const fs::path &folder)
{
  Json files = Json::object();
  for (const std::string &name : tree_of(folder))
    if (name != manifest_name && is_plain_file(folder / name))
      files[name] = description_of(read_text_file(folder / name));
  const Json manifest = { { "program", "stemware" }, { "files", files } };
  replace_text_file(folder / manifest_name, manifest.dump(2) + "\n");
}

std::optional<std::string> why_not_replaceable(const fs::path &folder)
{
  const std::vector<std::string> tree = tree_of(folder);
  if (tree.empty())
    return std::nullopt;
  const std::optional<Json> files = listed_files(folder);
  if (!files && is_older_summary(folder / "summary.json"))
    return "holds results without the list of their files that this version keeps (manifest.json), so that "
           "they cannot be told from files of yours";
  for (const std::string &name : tree)
  {
    if (files && name == manifest_name)
      continue;
    if (is_plain_folder(folder / name) && files && is_listed_folder(name, *files))
      continue;
    if (!files || !files->contains(name))
      return "holds " + name + ", which is not a result of Stemware";
    if (!is_as_listed(folder, name, *files))
      return "holds " + name + ", which has changed since Stemware wrote it";
  }
  return std::nullopt;
}

bool has_manifest(const fs::path &folder)
{
  return listed_files(folder).has_value();
}

void remove_listed_files(const fs::path &folder) noexcept
try
{
  const std::optional<Json> files = listed_files(folder);
  if (!files)
    return;
  std::vector<std::string> tree = tree_of(folder);
  std::reverse(tree.begin(), tree.end()); // what is in a folder before the folder
  std::error_code error;
  for (const std::string &name : tree)
    if (is_plain_folder(folder / name) || is_as_listed(folder, name, *files))
      fs::remove(folder / name, error); // fails for folders that something is in
  if (names_in(folder) == std::vector<std::string>{ manifest_name })
    fs::remove(folder / manifest_name, error);
  fs::remove(folder, error);
}
catch (const std::exception &)
{
  // What cannot be looked at stays.
}

} // namespace stemware::pipeline
