#include "fem/pipeline/support/manifest.h"

#include "fem/pipeline/support/folders.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/crc.hpp>

#include <fmt/format.h>
#include <map>

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

/// Content of a folder of results, by relative path: files by their description, folders as "folder", all
/// else as null. A folder comes before what is in it.
using Content = std::map<std::string, Json>;

Content content_of(const fs::path &folder)
{
  Content content;
  for (const auto &item : fs::recursive_directory_iterator(folder)) // follows no links
    content[item.path().lexically_relative(folder)] = is_plain_folder(item) ? Json("folder")
                                                      : is_plain_file(item)
                                                        ? description_of(read_text_file(item))
                                                        : Json();
  return content;
}

/// Content of @p folder by its manifest: the files listed, their folders, and the manifest itself; nothing
/// where there is no manifest of ours.
std::optional<Content> listed_in(const fs::path &folder)
{
  const fs::path file = folder / manifest_name;
  const std::string text = is_plain_file(file) ? read_text_file(file) : "";
  const std::optional<Json> manifest = json_in(text);
  if (!manifest || !manifest->is_object() || manifest->value("program", Json()) != "stemware" ||
      !manifest->value("files", Json()).is_object())
    return std::nullopt;
  Content listed = { { manifest_name, description_of(text) } };
  for (const auto &[name, description] : manifest->at("files").items())
  {
    listed[name] = description;
    for (auto slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
      listed[name.substr(0, slash)] = "folder";
  }
  return listed;
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
  for (const auto &[name, description] : content_of(folder))
    if (name != manifest_name && description.is_object())
      files[name] = description;
  const Json manifest = { { "program", "stemware" }, { "files", files } };
  replace_text_file(folder / manifest_name, manifest.dump(2) + "\n");
}

std::optional<std::string> why_not_replaceable(const fs::path &folder)
{
  const Content listed = listed_in(folder).value_or(Content());
  for (const auto &[name, description] : content_of(folder))
    if (const auto found = listed.find(name); found == listed.end())
      return "holds " + name + ", which is not a result of Stemware";
    else if (found->second != description)
      return "holds " + name + ", which has changed since Stemware wrote it";
  return std::nullopt;
}

bool has_manifest(const fs::path &folder)
{
  return listed_in(folder).has_value();
}

void remove_listed_files(const fs::path &folder) noexcept
try
{
  const Content listed = listed_in(folder).value_or(Content()), content = content_of(folder);
  std::error_code error;
  for (auto item = content.rbegin(); item != content.rend(); ++item) // what is in a folder before the folder
    if (const auto found = listed.find(item->first);
        item->first != manifest_name && found != listed.end() && found->second == item->second)
      fs::remove(folder / item->first, error); // fails for folders that something is in
  if (!listed.empty() && names_in(folder) == std::vector<std::string>{ manifest_name })
    fs::remove(folder / manifest_name, error);
  fs::remove(folder, error);
}
catch (const std::exception &)
{
  // What cannot be looked at stays.
}

} // namespace stemware::pipeline
