#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// A picture of a report, drawn by gnuplot as SVG and as PDF, or a drawing: an SVG as it stands.
struct Plot
{
  std::string name;           ///< file stem: figures/<name>.svg, .pdf, .gp and .dat; letters, digits, _ and -
  std::string caption;        ///< below the picture
  std::string script;         ///< gnuplot commands that load figures/style.gnuplot; data names the .dat
  std::string data = "";      ///< content of figures/<name>.dat; empty: no such file is written
  std::string data_file = ""; ///< without one: the file of the results that the picture is drawn from
  std::string drawing = "";   ///< the SVG itself; empty: the script makes it
  std::string label = "";     ///< what is to be seen, for those who do not see it; empty: the caption says it

  /// This picture under another name than that of its template, and with a caption of its own.
  Plot as(const std::string &name, const std::string &caption) const;
};

/// A value in a template: a truth (1 or 0), a number, a text, or a list of numbers or texts. A list x comes
/// with its length n_x.
using PlotValue = std::variant<bool, double, std::string, std::vector<double>, std::vector<std::string>>;

/// Values in a template, by the name of gnuplot's variable.
using PlotValues = std::vector<std::pair<std::string, PlotValue>>;

/// The picture of the template plots/<name>.gp: that of the folder share/stemware that comes with the
/// program, or else the one that is compiled in. Its first comment is the caption. Texts show the characters
/// that they have, with the subscripts of with_subscripts().
Plot plot_from(const std::string &name, const PlotValues &values = {}, const std::string &data = "");

/// The drawing of the template templates/<name>.svg, filled with @p facts as filled_text() does. Its first
/// title is what is to be seen, in numbers, its first desc the caption.
Plot drawing_from(const std::string &name, const nlohmann::ordered_json &facts);

/// Numbers for a picture: "# title", "# 1: name" for each column, then rows of numbers in groups, an empty
/// line between them: polygons, or the lines of a grid.
std::string grouped_data(const std::string &title, const std::vector<std::string> &columns,
                         const std::vector<std::vector<std::vector<double>>> &groups);

} // namespace stemware::pipeline
