#include "fem/pipeline/study/cookbooks.h"

#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/folders.h"
#include "fem/pipeline/support/shared_files.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

namespace fs = std::filesystem;

/// Where the cookbooks are; empty where they are not installed.
fs::path cookbook_folder()
{
  std::error_code error;
  for (const fs::path &shared : shared_folders())
    if (fs::is_directory(shared / "cookbooks", error))
      return shared / "cookbooks";
  return {};
}

} // namespace

std::vector<std::string> cookbook_names()
{
  std::vector<std::string> names;
  if (const fs::path folder = cookbook_folder(); !folder.empty())
    for (const std::string &name : names_in(folder))
      if (fs::path(name).extension() == ".prm")
        names.push_back(fs::path(name).stem());
  return names;
}

std::vector<StudyPart> cookbook_parts(const std::string &name, const fs::path &file)
{
  const fs::path folder = cookbook_folder();
  std::string places;
  for (const fs::path &shared : shared_folders())
    places += (places.empty() ? "" : " nor ") + (shared / "cookbooks").string();
  require(!folder.empty(),
          "The cookbooks are not installed with this program: there is neither " + places + ".");
  const std::vector<std::string> names = cookbook_names();
  const auto meant = likeliest(name, names);
  require(std::find(names.begin(), names.end(), name) != names.end(),
          "\"" + shortened(name) + "\" is no cookbook" +
            (meant ? "; did you mean " + *meant + "? There are " : "; there are ") +
            boost::algorithm::join(names, ", ") + ".");

  const fs::path study = folder / (name + ".prm");
  std::vector<StudyPart> parts = { { file, read_text_file(study) } };
  std::string &text = parts.front().text;
  boost::replace_all(text, "docs/cookbooks/" + name + ".prm", file.filename().string());
  for (const std::string &name_of_file : files_of(read_study(study)))
  {
    const fs::path read = name_of_file;
    require_regular_file("The file " + read.string() + " of the cookbook " + name, read);
    boost::replace_all(text, read.lexically_relative(folder).string(), read.filename().string());
    parts.push_back({ file.parent_path() / read.filename(), read_text_file(read) });
  }
  return parts;
}

} // namespace stemware::pipeline
