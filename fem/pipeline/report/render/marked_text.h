#pragma once

#include <string>

/// Plain texts as HTML and gnuplot write them. In both an underscore makes subscripts of the letters and
/// digits behind it where it follows a symbol of one letter, Latin or Greek (τ_z, a_10, z_CM); the
/// underscores of spin_up.csv are none.
namespace stemware::pipeline
{

/// A text without what means something to HTML, in elements and in quoted attributes.
std::string html_text(const std::string &text);

/// The text behind html_text().
std::string plain_text(const std::string &html);

/// html_text() with its subscripts.
std::string html_formula(const std::string &text);

/// A text with a true minus (U+2212) before its negative numbers; hyphens elsewhere stay.
std::string with_true_minus(const std::string &text);

/// Whether a cell is to be aligned as numbers are: a number, perhaps with its unit behind it, or nothing.
bool is_number(const std::string &cell);

/// A text in one of the forms that templates of HTML ask for, as it stands in another:
///
///   formula   html_formula()
///   flowing   that with true minus signs, and with numbers that stay on one line with their units
///   cell      of a table: as print shows numbers, 3.4 · 10⁻⁶ for 3.4e-06
std::string in_form(const std::string &text, const std::string &form);

/// Quotes a text for gnuplot: a string in single quotes that shows these characters, whatever they mean to
/// gnuplot, with the text's subscripts. Control characters become blanks.
std::string gnuplot_text(const std::string &text);

} // namespace stemware::pipeline
