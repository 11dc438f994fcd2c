#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/text_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <set>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// The texts of more cases than this do not fit into memory.
constexpr std::size_t largest_sweep = 1000000;

void require_different(const std::vector<SweptEntry> &entries)
{
  std::set<std::string> paths;
  for (const SweptEntry &entry : entries)
    require(paths.insert(entry.path).second,
            "The sweep varies " + entry.path + " twice; give all its values in one place.");
}

void require_allowed(std::size_t n_cases, const SweepRequest &request)
{
  require(n_cases <= largest_sweep,
          fmt::format(FMT_STRING("The sweep has {} cases, but at most {} are possible; "
                                 "ask for fewer."),
                      n_cases, largest_sweep));
  require(n_cases <= request.most_cases,
          fmt::format(FMT_STRING("The sweep has {} cases, about {} of work at half a second each, and {} are "
                                 "allowed; ask for fewer, or give --most-cases {}."),
                      n_cases, n_cases < 172800 ? "hours" : "days", request.most_cases, n_cases));
}

/// The value as a study file writes it, tried on the study of @p entry, which @p option names. Throws
/// BadInput where the entry does not take it, or the file that it names is not there.
std::string taken(const StudyEntry &entry, const std::string &option, const std::string &value)
{
  assign(entry, option + ": ", value);
  for (const std::string &file : files_of(*entry.study))
    require_regular_file(option + ": " + entry.path() + " = " + shortened_path(file), file);
  return entry.text();
}

/// Each value is one that the entry takes, and stands once.
void require_values(const StudyEntry &entry, const SweptEntry &varied)
{
  std::set<std::string> seen;
  for (const std::string &value : varied.values)
  {
    const std::string range = range_meant_by(value, varied.unit);
    require(range.empty(), fmt::format(FMT_STRING("--vary: {} = {} is not a number; did you mean \"{}={}\"?"),
                                       varied.path, value, varied.path, range));
    require(seen.insert(taken(entry, "--vary", value)).second,
            fmt::format(FMT_STRING("--vary: {} = {} stands twice; give each value once, and a range from one "
                                   "number to another."),
                        varied.path, shortened(value)));
  }
}

/// Each sample of a spread is one that the entry takes: without those that are not, the rest would be biased.
void require_samples(const SweepPlan &plan, std::size_t column)
{
  const Spread &spread = plan.spreads[column];
  const StudyEntry entry = find_entry("--random", spread.path);
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
    try
    {
      taken(entry, "--random", plan.cases[i][column]);
    }
    catch (const BadInput &refusal)
    {
      throw BadInput(fmt::format(FMT_STRING("{} That is sample {} of the spread ({}); narrow it, or write "
                                            "\"{}=median*/factor\", which stays above 0."),
                                 refusal.what(), i + 1, spread.description(), spread.path));
    }
}

SweepPlan make_grid(const SweepRequest &request)
{
  require(request.varied.size() <= 2, "The sweep varies " + std::to_string(request.varied.size()) +
                                        " entries; --vary takes one or two of them, --random any number.");
  SweepPlan plan;
  plan.cases = { {} };
  for (const std::string &text : request.varied)
  {
    const SweptEntry &varied = plan.entries.emplace_back(parse_varied_entry(text));
    const StudyEntry entry = find_entry("--vary", varied.path);
    require_allowed(plan.cases.size() * varied.values.size(), request);
    require_values(entry, varied);
    std::vector<std::vector<std::string>> cases;
    for (const auto &before : plan.cases)
      for (const std::string &value : varied.values)
        cases.emplace_back(before).push_back(value);
    plan.cases = std::move(cases);
  }
  return plan;
}

SweepPlan make_sample(const SweepRequest &request)
{
  require(2 <= request.n_samples, "--samples " + std::to_string(request.n_samples) +
                                    " is not allowed; give a whole number from 2 on.");
  require_allowed(request.n_samples, request);
  SweepPlan plan;
  plan.seed = request.seed;
  for (const std::string &text : request.random)
  {
    const Spread &spread = plan.spreads.emplace_back(parse_spread(text));
    const StudyEntry entry = find_entry("--random", spread.path);
    require(entry.quantity != nullptr,
            "--random: " + spread.path + " takes " + entry.allowed +
              ", which cannot be drawn from a spread; list its values with --vary.");
    plan.entries.push_back({ spread.path, entry.unit, {}, spread.is_by_factors() });
  }
  for (const std::vector<double> &sample : draw_samples(plan.spreads, request.n_samples, request.seed))
  {
    std::vector<std::string> &values = plan.cases.emplace_back();
    std::transform(sample.begin(), sample.end(), std::back_inserter(values), to_text);
  }
  for (std::size_t column = 0; column < plan.spreads.size(); ++column)
    require_samples(plan, column);
  return plan;
}

/// Values as numbers where they are some.
Json value_as_json(const SweptEntry &entry, const std::string &value)
{
  const auto number = entry.unit.empty() ? std::nullopt : parse_number(value);
  return number ? Json(*number) : Json(value);
}

/// Size and check sum of a file; null for one that cannot be read.
Json digest(const std::string &file)
{
  if (!std::ifstream(file))
    return nullptr;
  const std::string bytes = read_text_file(file);
  return { { "bytes", bytes.size() }, { "crc64", std::to_string(std::hash<std::string>{}(bytes)) } };
}

/// The files that some case reads.
std::set<std::string> files_of(const SweepPlan &plan)
{
  std::set<std::string> files;
  const auto add = [&](const Study &study)
  {
    for (const std::string &file : files_of(study))
      files.insert(file);
  };
  add(plan.base);
  const auto is_word = [](const SweptEntry &entry) { return entry.unit.empty(); };
  if (std::any_of(plan.entries.begin(), plan.entries.end(), is_word))
    for (std::size_t i = 0; i < plan.cases.size(); ++i)
      try
      {
        add(plan.study_of(i));
      }
      catch (const BadInput &)
      {
        // A case that cannot be computed reads no files.
      }
  return files;
}

} // namespace

Study SweepPlan::study_of(std::size_t index) const
{
  std::vector<std::pair<std::string, std::string>> values;
  for (std::size_t i = 0; i < entries.size(); ++i)
    values.emplace_back(entries[i].path, cases.at(index)[i]);
  return with_values(base, is_random() ? "--random" : "--vary", values);
}

SweepPlan make_plan(const SweepRequest &request)
{
  require(!request.varied.empty() || !request.random.empty(),
          "There is nothing to vary; give --vary \"Section/Entry=first:last:number\" or --random "
          "\"Section/Entry=mean+-deviation\".");
  require(request.varied.empty() || request.random.empty(),
          "--vary and --random do not go together; run one sweep for the grid and one for the samples.");
  SweepPlan plan = request.random.empty() ? make_grid(request) : make_sample(request);
  require_different(plan.entries);
  return plan;
}

Json plan_as_json(const SweepPlan &plan)
{
  Json json = { { "kind", plan.is_random() ? "random" : "grid" }, { "cases", plan.cases.size() } };
  if (plan.is_random())
    json["seed"] = plan.seed;
  Json entries = Json::array();
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const SweptEntry &entry = plan.entries[i];
    Json one = { { "entry", entry.path }, { "unit", entry.unit } };
    if (plan.is_random())
      one.update(plan.spreads[i].as_json());
    else
      for (const std::string &value : entry.values)
        one["values"].push_back(value_as_json(entry, value));
    entries.push_back(one);
  }
  json["entries"] = entries;
  return json;
}

Json identity_of(const SweepPlan &plan)
{
  Json files = Json::object();
  for (const std::string &file : files_of(plan))
    files[file] = digest(file);
  return { { "program", { { "version", program_version() }, { "revision", program_revision() } } },
           { "parameters", study_as_json(plan.base) },
           { "sweep", plan_as_json(plan) },
           { "cases", plan.cases },
           { "files", files } };
}

} // namespace stemware::pipeline
