#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>

namespace stemware::pipeline
{

nlohmann::ordered_json table_facts(const Table &table)
{
  using Json = nlohmann::ordered_json;
  Json columns = Json::array(), rows = Json::array();
  rows.get_ref<Json::array_t &>().resize(table.n_rows(), { { "cells", Json::array() } });
  bool has_header = false;
  for (const Column &column : table.columns)
  {
    std::vector<std::string> cells;
    for (std::size_t row = 0; row < rows.size(); ++row)
      cells.push_back(shown(column, row, format::missing));
    const bool all_numbers = std::all_of(cells.begin(), cells.end(), is_number);
    const Quantity &quantity = column.quantity; // whose unit is not broken at the end of a line
    const std::string heading =
      with_unit(quantity.heading, boost::replace_all_copy(quantity.unit, " ", "\u00a0"), false);
    has_header = has_header || !heading.empty();
    columns.push_back({ { "heading", heading }, { "is_number", all_numbers } });
    for (std::size_t row = 0; row < rows.size(); ++row)
      rows[row]["cells"].push_back({ { "text", cells[row] }, { "is_number", all_numbers } });
  }
  return { { "name", table.title.empty() ? "table" : table.title },
           { "title", table.title },
           { "has_header", has_header },
           { "columns", columns },
           { "rows", rows } };
}

std::string html_table(const Table &table)
{
  return filled_text("table.html", table_facts(table));
}

} // namespace stemware::pipeline
