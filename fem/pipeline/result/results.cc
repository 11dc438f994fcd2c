#include "fem/pipeline/result/results.h"

#include "fem/pipeline/base/numbers.h"

#include <boost/algorithm/string/trim.hpp>

#include <cmath>
#include <cstdint>

namespace stemware::pipeline
{

void Results::add_table(const std::string &name, const Table &table, Face face)
{
  const bool is_picture = face == Face::picture;
  const int n_digits = is_picture ? 6 : 10;
  Json &shown = tables[name] = { { "keys", Json::array() }, { "values", Json::array() } };
  for (const auto &[quantity, cells] : table.columns)
  {
    shown["keys"].push_back(is_picture ? quantity.word(face) : quantity.key);
    Json &values = shown["values"].emplace_back(Json::array());
    for (const Json &cell : cells)
      values.push_back(cell.is_number_float() ? rounded_number(cell.get<double>(), n_digits) : cell);
    if (!is_picture)
      quantities[name][quantity.key] = { { "heading", boost::trim_copy(quantity.heading) },
                                         { "unit", quantity.unit },
                                         { "digits", quantity.digits } };
  }
}

Json rounded_number(double value, int n_digits)
{
  if (!std::isfinite(value))
    return nullptr;
  const double number = rounded(value, n_digits);
  if (number == std::round(number) && std::abs(number) < 1e15)
    return static_cast<std::int64_t>(number); // "3" is shorter than "3.0"
  return number;
}

Json rounded_number(const std::vector<double> &values, int n_digits)
{
  Json list = Json::array();
  for (const double value : values)
    list.push_back(rounded_number(value, n_digits));
  return list;
}

} // namespace stemware::pipeline
