#include "fem/pipeline/analysis/free_entries.h"

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <vector>

namespace stemware::pipeline
{

namespace
{

Prior value_or_prior(const std::string &option, const std::string &text, const std::string &unit,
                     const std::string &cure)
{
  const auto alone = parse_quantity(text, unit);
  const auto prior = alone ? std::optional(Prior{ *alone, 0 }) : parse_prior(text, unit);
  ensure(prior.has_value(), option + shortened(text) + cure);
  return *prior;
}

} // namespace

std::optional<Prior> parse_prior(const std::string &text, const std::string &unit)
{
  std::string plain = text;
  for (const char *sign : { "+/-", "+-" })
    boost::replace_all(plain, sign, "±");
  const std::string mark = "±";
  const auto at = plain.find(mark);
  if (at == plain.npos)
    return std::nullopt;
  const std::vector<std::string> parts = with_shared_unit(
    { boost::trim_copy(plain.substr(0, at)), boost::trim_copy(plain.substr(at + mark.size())) });
  const auto value = parse_quantity(parts[0], unit), spread = parse_quantity(parts[1], unit);
  return value && spread && *spread >= 0 ? std::optional(Prior{ *value, *spread }) : std::nullopt;
}

FreeEntry parse_free_entry(const std::string &text)
{
  const auto equals = text.find('=');
  const std::vector<StudyEntry> entries = entries_of(Study());
  const StudyEntry &entry = entry_at(entries, "--free ", boost::trim_copy(text.substr(0, equals)));
  ensure(entry.quantity != nullptr, "--free " + entry.path() + " is no number that can be fitted.");
  FreeEntry free = { entry.path() };
  if (equals != text.npos)
  {
    free.prior = parse_prior(text.substr(equals + 1), entry.unit);
    ensure(free.prior && free.prior->spread > 0,
           "--free " + shortened(text) +
             " gives no prior; write value ± spread, or value +- spread, such as \"" + entry.path() +
             " = 0.3 +- 0.02\".");
  }
  return free;
}

Prior parse_gyroscope_zero(const std::string &text)
{
  return value_or_prior("--gyroscope-zero ", text, "rad/s",
                        " is no spin; write \"0 +- 0.02 rad/s\", or 0 if there is no zero.");
}

Prior parse_start(const std::string &text)
{
  return value_or_prior("--start ", text, "s",
                        " is no time; write \"1.2 +- 0.05 s\", or 1.2 for a start that is known.");
}

FitQuestion fit_question(const std::vector<std::string> &free, const std::string &gyroscope_zero,
                         const std::string &start, bool quick)
{
  FitQuestion question;
  for (const std::string &entry : free)
    question.free.push_back(parse_free_entry(entry));
  if (!gyroscope_zero.empty())
    question.gyroscope_zero = parse_gyroscope_zero(gyroscope_zero);
  if (!start.empty())
    question.start = parse_start(start);
  question.with_profiles = question.with_next_run = !quick;
  return question;
}

} // namespace stemware::pipeline
