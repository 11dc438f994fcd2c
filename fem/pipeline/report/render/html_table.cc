#include "fem/pipeline/report/render/html_page.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <regex>

namespace stemware::pipeline
{

namespace
{

/// Whether a cell is to be aligned as numbers are: a number, perhaps with its unit behind it, or nothing.
bool is_number(const std::string &cell)
{
  const std::size_t digit = cell.find_first_not_of("+-");
  return cell.empty() || cell == "–" ||
         (digit != std::string::npos && digit < 2 && std::isdigit(static_cast<unsigned char>(cell[digit])));
}

/// A number as print shows it: a true minus, and 3.4 · 10⁻⁶ for 3.4e-06.
std::string html_number(const std::string &cell)
{
  static const std::regex power("(^|[^0-9.])([0-9.]+)e([+-])0*([0-9]+)");
  std::string html, rest = html_formula(cell);
  for (std::smatch match; std::regex_search(rest, match, power); rest = match.suffix())
    html += match.prefix().str() + match[1].str() + (match[2] == "1" ? "" : match[2].str() + " · ") +
            "10<sup>" + (match[3] == "-" ? "\u2212" : "") + match[4].str() + "</sup>";
  return with_true_minus(html + rest);
}

/// Heading with a unit that is not broken at the end of a line.
std::string heading_of(const Quantity &quantity)
{
  return with_unit(quantity.heading, boost::replace_all_copy(quantity.unit, " ", "\u00a0"), false);
}

} // namespace

std::string html_table(const Table &table)
{
  std::string head;
  std::vector<std::string> rows(table.n_rows());
  bool has_header = false;
  for (const Column &column : table.columns)
  {
    std::vector<std::string> cells;
    for (std::size_t row = 0; row < rows.size(); ++row)
      cells.push_back(shown(column, row, "–"));
    const std::string type = std::all_of(cells.begin(), cells.end(), is_number) ? " class=\"number\"" : "";
    const std::string heading = heading_of(column.quantity);
    has_header = has_header || !heading.empty();
    head += "<th scope=\"col\"" + type + ">" + html_formula(heading) + "</th>";
    for (std::size_t row = 0; row < rows.size(); ++row)
      rows[row] +=
        "<td" + type + ">" +
        (is_number(cells[row]) ? html_number(cells[row]) : with_true_minus(html_formula(cells[row]))) +
        "</td>";
  }
  const std::string name = html_text(table.title.empty() ? "table" : table.title);
  std::string html =
    "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"" + name + "\"><table>\n";
  if (!table.title.empty())
    html += "<caption>" + html_formula(table.title) + "</caption>\n";
  if (has_header)
    html += "<thead><tr>" + head + "</tr>\n</thead>\n";
  html += "<tbody>\n";
  for (const std::string &row : rows)
    html += "<tr>" + row + "</tr>\n";
  return html + "</tbody>\n</table>\n</div>\n";
}

} // namespace stemware::pipeline
