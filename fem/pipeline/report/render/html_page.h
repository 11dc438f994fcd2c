#pragma once

#include "fem/pipeline/report/render/report.h"

#include <map>
#include <string>

namespace stemware::pipeline
{

/// The page of a report as HTML5 that is well-formed XML too. @p pictures holds the SVG of each plot that
/// was drawn, by the plot's name; @p notice, unless empty, is shown below the answer.
std::string html_page(const Report &report, const std::map<std::string, std::string> &pictures,
                      const std::string &notice);

/// A text without what means something to HTML, in elements and in quoted attributes.
std::string html_text(const std::string &text);

/// The text behind html_text().
std::string plain_text(const std::string &html);

/// html_text() with the subscripts of with_subscripts().
std::string html_formula(const std::string &text);

/// A text with a true minus (U+2212) before its negative numbers; hyphens elsewhere stay.
std::string with_true_minus(const std::string &text);

/// An SVG document of gnuplot as an element of a page: as wide as the page allows, with ids that begin with
/// @p name so that pictures do not borrow each other's parts, and with @p label as its name.
std::string inline_svg(const std::string &svg, const std::string &name, const std::string &label);

} // namespace stemware::pipeline
