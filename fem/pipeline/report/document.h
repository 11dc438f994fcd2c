#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/report/results.h"

#include <map>
#include <string>

namespace stemware::pipeline
{

/// Findings of a verb, and all that a template may show of them. SI units, or those of the study.
struct Document
{
  Findings findings; ///< for summary.json and --json
  /// Words, flags and derived numbers for sentences, which see the findings too.
  nlohmann::ordered_json facts = nlohmann::ordered_json::object();
  std::map<std::string, Table> tables = {};
  std::map<std::string, std::string> texts = {};            ///< files that are no table
  std::map<std::string, nlohmann::ordered_json> plots = {}; ///< values of a picture's own, by its name
  std::vector<fem::FieldFile> fields = {};
};

/// The @p document as the template fem/pipeline/report/templates/NAME.txt shows it, filled as filled_text()
/// says. Its lines:
///
///   = TITLE                          of the page; what follows is the answer
///   # HEADING                        a section; "#> HEADING" is folded
///   text                             lines are joined by a blank, those that begin with , ; . or ) by
///                                    nothing; a line "@p" parts paragraphs
///   @inputs                          what follows is the line of inputs under the title, until "@answer"
///   @drawing NAME                    templates/NAME.svg, filled likewise; in front of the first section a
///                                    picture of the head
///   @plot NAME | WORDS               the picture of plots/NAME.gp as plot_from() makes it, with what is to
///   be
///                                    seen, in numbers, for those who do not see it; without words the
///                                    caption says it
///   @plot NAME = SOURCE | WORDS      that of plots/SOURCE.gp, as figures/NAME.svg
///   @table NAME                      all columns under the table's own title
///   @table NAME: KEY KEY | TITLE     these columns under this title (Table::with())
///   @file FILE = NAME | WORDS        a file of the text, table or columns NAME, listed with WORDS unless
///                                    they are empty; without "= NAME" one that is written elsewhere. Where
///                                    the columns of FILE.csv stand, pictures know by their keys, from 1 on:
///                                    {{columns.FILE.KEY}}
///   @console                         what follows is the console's; "@block" begins a new part of it, and so
///                                    does what follows a table
///
/// Empty lines mean nothing. Throws std::logic_error for another line, and for a name that the document does
/// not have.
Results shown(const Document &document, const std::string &name);

/// A text of the @p document, one of its tables, "NAME", or columns of one, "NAME: KEY KEY". Throws
/// std::logic_error for a name that it does not have.
Content content_of(const Document &document, const std::string &what);

/// The picture @p name of plots/@p source.gp with the values that the @p document has for it, @p facts being
/// those of all texts.
Plot picture_of(const Document &document, const nlohmann::ordered_json &facts, const std::string &name,
                const std::string &source);

} // namespace stemware::pipeline
