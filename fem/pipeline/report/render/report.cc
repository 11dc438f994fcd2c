#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/results.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/finder.hpp>
#include <boost/algorithm/string/iter_find.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <iostream>
#include <string>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

/// An SVG document of gnuplot as an element of a page: as wide as the page allows, with ids that begin with
/// @p name so that pictures do not borrow each other's parts, and with @p label as its name.
std::string inline_svg(const std::string &svg, const std::string &name, const std::string &label)
{
  const std::size_t root = std::min(svg.find("<svg"), svg.size()); // after the document's own beginning
  const std::size_t content = std::min(svg.find('>', root), svg.size() - 1) + 1;
  const std::string tag = svg.substr(root, content - root), mark = " viewBox=\"";
  const std::size_t box = tag.find(mark), box_end = box < tag.size() ? tag.find('"', box + mark.size()) : box;
  const std::string view_box = box_end < tag.size() ? tag.substr(box, box_end + 1 - box) : "";
  std::string body = svg.substr(content);
  for (const std::string name_of_tag : { "title", "desc" }) // shown where the mouse rests
  {
    const std::string end = "</" + name_of_tag + ">";
    const std::size_t first = body.find("<" + name_of_tag + ">"), last = body.find(end, first);
    if (last < body.size())
      body.erase(first, last + end.size() - first);
  }
  for (const std::string beginning : { " id='", " id=\"", "href='#", "href=\"#", "url(#" })
    boost::replace_all(body, beginning, beginning + name + "-");
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"" + view_box +
         " role=\"img\" aria-label=\"" + html_text(label) + "\">" + body;
}

/// Pictures for the template figures.html; those that were drawn have the SVG of their file in @p folder.
Json figures_of(const std::vector<Plot> &plots, const fs::path &folder)
{
  Json figures = Json::array();
  for (const Plot &plot : plots)
  {
    const std::string stem = "figures/" + plot.name, svg = read_text_file(folder / (stem + ".svg"));
    const std::string &label = plot.label.empty() ? plot.caption : plot.label;
    figures.push_back({ { "name", plot.name },
                        { "caption", plot.caption },
                        { "is_drawing", !plot.drawing.empty() },
                        { "svg", svg.empty() ? "" : inline_svg(svg, plot.name, label) },
                        { "data", plot.data.empty() ? plot.data_file : stem + ".dat" } });
  }
  return figures;
}

Json section_of(const ReportSection &section, const fs::path &folder)
{
  std::vector<std::string> paragraphs;
  if (!section.text.empty())
    boost::iter_split(paragraphs, section.text, boost::first_finder("\n\n"));
  Json tables = Json::array(), files = Json::array();
  for (const Table &table : section.tables)
    tables.push_back(table_facts(table));
  for (const ResultFile &file : section.files)
    files.push_back({ { "name", file.name }, { "description", file.description } });
  return { { "heading", section.heading }, { "folded", section.folded },
           { "paragraphs", paragraphs },   { "figures", figures_of(section.plots, folder) },
           { "tables", tables },           { "files", files } };
}

} // namespace

void write_report(const Report &report, const fs::path &folder)
{
  std::vector<Plot> plots = report.pictures;
  for (const ReportSection &section : report.sections)
    plots.insert(plots.end(), section.plots.begin(), section.plots.end());
  const std::string notice = draw_plots(plots, folder);
  if (!notice.empty() && notice != missing_plotter())
    std::cerr << "stemware: " << notice << std::endl;

  Json page = { { "title", report.title },
                { "inputs", report.inputs },
                { "figures", figures_of(report.pictures, folder) },
                { "answer", report.answer },
                { "notice", notice },
                { "sections", Json::array() },
                { "program", program_version() + " (" + program_revision() + ")" } };
  for (const ReportSection &section : report.sections)
    page["sections"].push_back(section_of(section, folder));
  write_text_file(folder / "report.html", filled_text("report.html", page));
}

} // namespace stemware::pipeline
