#include "fem/pipeline/support/csv_text.h"

namespace stemware::pipeline
{

namespace
{

std::string field(const std::string &text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

} // namespace

std::string csv_record(const std::vector<std::string> &fields)
{
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i == 0 ? "" : ",") + field(fields[i]);
  return line + "\r\n";
}

std::string column_title(const std::string &name, const std::string &unit)
{
  return unit.empty() ? name : name + " (" + unit + ")";
}

} // namespace stemware::pipeline
