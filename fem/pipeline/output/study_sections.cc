#include "fem/pipeline/output/study_sections.h"

#include "fem/pipeline/study/study_entries.h"

namespace stemware::pipeline
{

namespace
{

/// The unit at the end of what an entry takes: "a number greater than 0 (m)".
std::string unit_of(const StudyEntry &entry)
{
  const auto begin = entry.allowed.rfind('(');
  return begin == std::string::npos || entry.allowed.back() != ')'
           ? ""
           : entry.allowed.substr(begin + 1, entry.allowed.size() - begin - 2);
}

std::string value_of(const StudyEntry &entry)
{
  const std::string text = entry.text();
  return text.empty() ? "(none)" : text;
}

} // namespace

std::vector<ReportSection> study_sections(const Study &study)
{
  Study given = study, usual;
  const std::vector<StudyEntry> entries = study_entries(given), defaults = study_entries(usual);
  ReportTable changed = { "", { "entry", "value", "default", "unit" }, {} };
  ReportTable all = { "", { "entry", "value", "unit", "meaning" }, {} };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const StudyEntry &entry = entries[i];
    if (entry.text() != defaults[i].text())
      changed.rows.push_back({ entry.path(), value_of(entry), value_of(defaults[i]), unit_of(entry) });
    all.rows.push_back({ entry.path(), value_of(entry), unit_of(entry), entry.help });
  }
  ReportSection differences = { "The study", "What differs from the defaults (stemware defaults):" };
  if (changed.rows.empty())
    differences.text = "Everything has its default value (stemware defaults).";
  else
    differences.tables.push_back(changed);
  ReportSection everything = { "All parameters", "", {}, { all } };
  everything.folded = true;
  return { differences, everything };
}

} // namespace stemware::pipeline
