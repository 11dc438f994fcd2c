#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <set>

namespace stemware::test
{
namespace
{

using Json = nlohmann::ordered_json;

/// Returns true if @p text equals @p pattern with a number in place of the asterisk.
bool matches(const std::string &text, const std::string &pattern)
{
  const auto star = pattern.find('*');
  if (star == pattern.npos)
    return text == pattern;
  const std::string end = pattern.substr(star + 1);
  if (text.size() < pattern.size() || text.compare(0, star, pattern, 0, star) != 0 ||
      text.compare(text.size() - end.size(), end.size(), end) != 0)
    return false;
  const std::string number = text.substr(star, text.size() - star - end.size());
  return number.find_first_not_of("0123456789+-.e") == number.npos;
}

/// Returns the keys of the columns with the heading @p heading, "name (unit)".
std::vector<std::string> keys_of(const Json &columns, const std::string &heading)
{
  std::vector<std::string> keys;
  for (const auto &[key, column] : columns.items())
  {
    const std::string unit = column["unit"];
    const Json names = column.value("name", Json(key));
    for (const Json &name : names.is_array() ? names : Json::array({ names }))
      if (matches(heading, name.get<std::string>() + (unit.empty() ? "" : " (" + unit + ")")) ||
          (unit == "1" && matches(heading, name.get<std::string>()))) // sweep.csv omits the unit "1"
        keys.push_back(key);
  }
  return keys;
}

TEST(ColumnKeys, EveryColumnOfEveryFileIsDeclaredOnce)
{
  const Json files = Json::parse(pipeline::summary_schema())["definitions"]["files"];
  const ScratchFolder scratch;
  scratch.write("study.prm", plain_study("subsection Contact\n  set Body = revolution\n  set Harmonics = 6\n"
                                         "  set Azimuth lines = 64\nend\n"));
  std::set<std::string> seen;
  for (const std::vector<std::string> &verb : { std::vector<std::string>{ "run" },
                                                { "truncate" },
                                                { "converge", "--levels", "2" },
                                                { "sweep", "--vary", "Motion/Mass=0.3,0.31" },
                                                { "run", "--quick", "--set", "Glass/Rim waviness=3: 1e-6" } })
  {
    std::vector<std::string> arguments = verb;
    arguments.insert(arguments.begin() + 1, "study.prm");
    const std::string folder = "results of " + verb.front();
    arguments.insert(arguments.end(), { "--quiet", "--output", folder });
    const Ended ended = stemware(scratch, arguments);
    ASSERT_EQ(ended.exit_code, 0) << verb[0] << ": " << ended.err;
    for (const auto &item : std::filesystem::directory_iterator(scratch / folder))
      if (const std::string file = item.path().filename().string(); item.path().extension() == ".csv")
      {
        seen.insert(file);
        const Json columns = files.value(file, Json::object());
        const auto rows = parse_csv(read_text(item.path()));
        for (const std::string &heading : rows.front())
          if (heading != "Motion/Mass (kg)") // varied entry, not in the schema
          {
            EXPECT_EQ(keys_of(columns, heading).size(), 1u) << verb[0] << ", " << file << ": " << heading;
          }
      }
  }
  EXPECT_GE(seen.size(), 11u);
}

} // namespace
} // namespace stemware::test
