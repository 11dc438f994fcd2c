#pragma once

#include "fem/pipeline/document/table.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
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
};

/// Data that a template may ask for by name: a table, or a text that is written as it stands.
using Content = std::variant<std::monostate, Table, std::string>;

/// The picture @p name of the template plots/@p source.gp: that of the folder share/stemware that comes with
/// the program, or else the one that is compiled in. A template is gnuplot's, and may have
///
///   # words               at its beginning: the caption
///   #@data WHAT | TITLE   a @p content, as "@file FILE = WHAT" of a report names it, the title that of rows
///                         of the document; it goes to figures/<name>.dat, the next one behind it as another
///                         index. Columns of words become gnuplot's arrays, by their keys.
///   #@one_way             what is shown depends on the spin: where the fact one_way is true, picture and
///                         caption say so
///   {{fact}}              in the caption as in all texts of a report (filled_text()), elsewhere as gnuplot
///                         writes it: with all digits, a truth as 1 or 0, NaN for what does not exist, words
///                         in quotes
///
/// Facts are @p facts, with the picture's own @p values before them, and "plot", its name. The @p values
/// stand before the script, too, as variables of gnuplot; a list x comes with its length n_x. Words show the
/// characters that they have, with the subscripts of gnuplot_text(). A template that asks for something
/// which there is not makes a plot that gnuplot refuses with a sentence about it; std::logic_error is thrown
/// where there is no template.
Plot plot_from(const std::string &name, const std::string &source, nlohmann::ordered_json facts,
               const nlohmann::ordered_json &values,
               const std::function<Content(const std::string &)> &content);

/// The drawing of the template templates/<name>.svg, filled with @p facts as filled_text() does. Its first
/// title is what is to be seen, in numbers, its first desc the caption.
Plot drawing_from(const std::string &name, const nlohmann::ordered_json &facts);

/// Numbers for a picture: "# title", "# 1: name" for each column, then rows of numbers in groups, an empty
/// line between them: polygons, or the lines of a grid.
std::string grouped_data(const std::string &title, const std::vector<std::string> &columns,
                         const std::vector<std::vector<std::vector<double>>> &groups);

/// Warning before long work where no gnuplot can be found: the report will then have no pictures, but their
/// scripts and data. Empty where there is one.
std::string missing_plotter();

/// The text of a file of plots/: of the folder share/stemware that comes with the program, where it has one,
/// or else as it was compiled in. Throws std::logic_error for a file that there is not.
std::string plot_file_text(const std::string &name);

/// Writes figures/style.gnuplot, the drawings among @p plots and the scripts and data of the others into
/// @p folder, then lets gnuplot draw those, SVG and PDF side by side. A plot that fails costs the others
/// nothing. Returns one or more sentences on what could not be drawn and why; empty when everything was.
/// Throws OutputFailure.
std::string draw_plots(const std::vector<Plot> &plots, const std::filesystem::path &folder);

} // namespace stemware::pipeline
