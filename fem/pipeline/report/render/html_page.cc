#include "fem/pipeline/report/render/html_page.h"

#include "fem/pipeline/report/formula_text.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/shared_files.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <regex>

namespace stemware::pipeline
{

/// The files of templates/.
const CompiledTexts &compiled_pages();

namespace
{

/// Entities of characters that mean something to HTML; the one that all begin with comes last.
const std::vector<std::pair<std::string, std::string>> entities = { { "&lt;", "<" },
                                                                    { "&gt;", ">" },
                                                                    { "&quot;", "\"" },
                                                                    { "&#39;", "'" },
                                                                    { "&amp;", "&" } };

/// An element with its content.
std::string element(const std::string &tag, const std::string &content)
{
  return "<" + tag + ">" + content + "</" + tag.substr(0, tag.find(' ')) + ">\n";
}

std::string link(const std::string &file, const std::string &text)
{
  return "<a href=\"" + html_text(file) + "\">" + html_text(text) + "</a>";
}

/// A text as HTML; numbers have a true minus and stay on one line with their units.
std::string flowing_text(const std::string &text)
{
  std::string html = with_true_minus(html_formula(text));
  for (const std::string unit : { "%", "rad/s" })
    boost::replace_all(html, " " + unit, "\u00a0" + unit);
  return html;
}

std::string paragraphs(const std::string &text)
{
  std::string html;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find("\n\n", begin), text.size());
    html += element("p", flowing_text(text.substr(begin, end - begin)));
    begin = end + 2;
  }
  return html;
}

std::string figure(const Plot &plot, const std::map<std::string, std::string> &pictures)
{
  const std::string stem = "figures/" + plot.name + ".";
  const auto picture = pictures.find(plot.name);
  const bool drawn = picture != pictures.end();
  std::string files;
  if (!plot.drawing.empty())
    files = link(stem + "svg", "SVG");
  else
  {
    if (drawn)
      files = link(stem + "svg", "SVG") + " · " + link(stem + "pdf", "PDF") + " · ";
    if (const std::string data = plot.data.empty() ? plot.data_file : stem + "dat"; !data.empty())
      files += link(data, "data") + " · ";
    files += link(stem + "gp", "script");
  }
  return element(
    "figure id=\"" + plot.name + (plot.drawing.empty() ? "\"" : "\" class=\"drawing\""),
    "\n" +
      (drawn ? inline_svg(picture->second, plot.name, plot.label.empty() ? plot.caption : plot.label)
             : element("p class=\"missing\"", "This plot has not been drawn.")) +
      element("figcaption", flowing_text(plot.caption) + " <span class=\"files\">" + files + "</span>"));
}

/// Pictures side by side where there is room; nothing without one.
std::string figure_row(const std::vector<Plot> &plots, const std::map<std::string, std::string> &pictures)
{
  std::string figures;
  for (const Plot &plot : plots)
    figures += figure(plot, pictures);
  return figures.empty() ? "" : element("div class=\"figures\"", "\n" + figures);
}

std::string file_list(const std::vector<FileNote> &files)
{
  std::string items;
  for (const FileNote &file : files)
    items += element("dt", link(file.name, file.name)) + element("dd", html_formula(file.description));
  return items.empty() ? "" : element("dl", "\n" + items);
}

std::string section(const ReportSection &section, const std::map<std::string, std::string> &pictures)
{
  std::string content = paragraphs(section.text) + figure_row(section.plots, pictures);
  for (const Table &table : section.tables)
    content += html_table(table);
  content += file_list(section.files);
  const std::string heading = element("h2", html_formula(section.heading));
  return element("section",
                 "\n" + (section.folded ? element("details", "\n" + element("summary", heading) + content)
                                        : heading + content));
}

std::string attribute(const std::string &tag, const std::string &name)
{
  const auto begin = tag.find(" " + name + "=\"");
  if (begin == std::string::npos)
    return "";
  const auto value = begin + name.size() + 3;
  return tag.substr(value, tag.find('"', value) - value);
}

/// Removes the first element with this tag.
void remove_element(std::string &text, const std::string &tag)
{
  const auto begin = text.find("<" + tag + ">");
  const auto end = text.find("</" + tag + ">", begin);
  if (begin != std::string::npos && end != std::string::npos)
    text.erase(begin, end + tag.size() + 3 - begin);
}

} // namespace

std::string html_text(const std::string &text)
{
  std::string safe;
  for (const char character : text)
  {
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [=](const auto &entity) { return entity.second[0] == character; });
    safe += found == entities.end() ? std::string(1, character) : found->first;
  }
  return safe;
}

std::string plain_text(const std::string &html)
{
  std::string text = html;
  for (const auto &[entity, character] : entities)
    boost::replace_all(text, entity, character);
  return text;
}

std::string html_formula(const std::string &text)
{
  return with_subscripts(text, html_text, "<sub>", "</sub>");
}

std::string with_true_minus(const std::string &text)
{
  static const std::regex minus("(^|[\\s(\\[<>=±≤,])-(?=[0-9])");
  return std::regex_replace(text, minus, "$1\u2212");
}

std::string inline_svg(const std::string &svg, const std::string &name, const std::string &label)
{
  const std::size_t root = std::min(svg.find("<svg"), svg.size()); // after the document's own beginning
  const std::size_t content = std::min(svg.find('>', root), svg.size() - 1) + 1;
  const std::string tag = svg.substr(root, content - root);
  std::string body = svg.substr(content);
  remove_element(body, "title"); // browsers would show these when the mouse rests
  remove_element(body, "desc");
  for (const std::string beginning : { " id='", " id=\"", "href='#", "href=\"#", "url(#" })
    boost::replace_all(body, beginning, beginning + name + "-");
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"" +
         attribute(tag, "viewBox") + "\" role=\"img\" aria-label=\"" + html_text(label) + "\">" + body;
}

std::string html_page(const Report &report, const std::map<std::string, std::string> &pictures,
                      const std::string &notice)
{
  std::string content = element("h1", html_formula(report.title));
  if (!report.inputs.empty())
    content += element("p class=\"inputs\"", flowing_text(report.inputs));
  content +=
    figure_row(report.pictures, pictures) + element("p class=\"answer\"", flowing_text(report.answer));
  if (!notice.empty())
    content += element("p class=\"notice\" role=\"note\"", html_text(notice));
  for (const ReportSection &item : report.sections)
    content += section(item, pictures);
  content += element("footer", "Stemware " + html_text(program_version() + " (" + program_revision() + ")"));
  return "<!DOCTYPE html>\n" +
         element("html lang=\"en\"",
                 "\n<head>\n<meta charset=\"utf-8\"/>\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
                 "<link rel=\"icon\" href=\"data:,\"/>\n" +
                   element("title", html_text(report.title)) +
                   element("style", "\n" + text_of(compiled_pages(), "page.css")) + "</head>\n" +
                   element("body", "\n" + element("main", "\n" + content)));
}

} // namespace stemware::pipeline
