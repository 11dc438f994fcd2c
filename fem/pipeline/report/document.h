#pragma once

#include "fem/pipeline/document/document.h"
#include "fem/pipeline/report/results.h"

#include <string>

namespace stemware::pipeline
{

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
///                                    be seen, in numbers, for those who do not see it; without words the
///                                    caption says it
///   @plot NAME = SOURCE | WORDS      that of plots/SOURCE.gp, as figures/NAME.svg
///   @table NAME: KEY KEY | TITLE     rows of the findings or facts, a list of objects: NAME is a path,
///                                    chain.rows, the keys are columns, by default all;
///                                    summary.schema.json declares them, for the first part of NAME or for
///                                    all
///   @list NAME: KEY KEY | TITLE      one object as a list of what it is and how large; without keys a part
///   of the
///                                    findings, those of its numbers that summary.schema.json calls "listed"
///   @words KEY KEY | TITLE           a table of words, which has a row in each line "@row WORD | WORD"
///   @file FILE = NAME: KEY KEY | WORDS  a file of the text or table NAME, listed with WORDS unless they are
///                                    empty; without "= NAME" one that is written elsewhere. Where the
///                                    columns of FILE.csv stand, pictures know by their keys, from 1 on:
///                                    {{columns.FILE.KEY}}
///   @console                         what follows is the console's; "@block" begins a new part of it, and so
///                                    does what follows a table
///
/// Empty lines mean nothing. Throws std::logic_error for another line, and for a name that the document does
/// not have.
Results shown(const Document &document, const std::string &name);

/// The picture @p name of plots/@p source.gp with the values that the @p document has for it, @p facts being
/// those of all texts.
Plot picture_of(const Document &document, const nlohmann::ordered_json &facts, const std::string &name,
                const std::string &source);

} // namespace stemware::pipeline
