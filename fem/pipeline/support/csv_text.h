#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// One line of a table as RFC 4180 has it: commas, CRLF, fields with commas, quotes or line ends in double
/// quotes.
std::string csv_record(const std::vector<std::string> &fields);

/// "name (unit)", or the name alone where there is no unit.
std::string column_title(const std::string &name, const std::string &unit);

} // namespace stemware::pipeline
