#include "fem/pipeline/result/document.h"

#include <boost/algorithm/string/trim.hpp>

namespace stemware::pipeline
{

void Document::add_table(const std::string &name, const Table &table)
{
  constexpr int n_digits = 10;
  Json &shown = tables[name] = { { "keys", Json::array() }, { "values", Json::array() } };
  for (const auto &[quantity, cells] : table.columns)
  {
    shown["keys"].push_back(quantity.key);
    Json &values = shown["values"].emplace_back(Json::array());
    for (const Json &cell : cells)
      values.push_back(cell.is_number_float() ? shortened(cell.get<double>(), n_digits) : cell);
    quantities[name][quantity.key] = { { "heading", boost::trim_copy(quantity.heading) },
                                       { "unit", quantity.unit },
                                       { "digits", quantity.digits } };
  }
}

} // namespace stemware::pipeline
