#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/text.h"

#include <algorithm>

namespace stemware::pipeline
{

std::string console_table(const Table &table)
{
  std::vector<TextColumn> columns;
  for (const Column &column : table.columns)
  {
    const Quantity &quantity = column.quantity;
    const bool has_unit = !quantity.unit.empty() && quantity.unit != "1";
    TextColumn &text = columns.emplace_back();
    text.header = quantity.label + (has_unit ? "\n(" + quantity.unit + ")" : "");
    for (std::size_t row = 0; row < column.cells.size(); ++row)
      text.cells.push_back(shown(column, row, "-", true));
    text.is_text = quantity.unit.empty() &&
                   std::any_of(column.cells.begin(), column.cells.end(),
                               [](const Cell &cell) { return std::holds_alternative<std::string>(cell); });
  }
  return (table.title.empty() ? "" : table.title + '\n') + text_table(columns);
}

} // namespace stemware::pipeline
