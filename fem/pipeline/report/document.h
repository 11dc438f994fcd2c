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
///   @plot NAME | WORDS               of the document, else plots/NAME.gp as it stands; with what is to be
///                                    seen, in numbers, for those who do not see it, else as the caption
///   @table NAME: KEY KEY | TITLE     rows of the findings or facts, a list of objects: NAME is a path,
///                                    chain.rows, the keys are columns, by default all; quantities.json
///                                    declares them, in a section for the first part of NAME or for all
///   @list NAME: KEY KEY | TITLE      one object as a list of what it is and how large
///   @words KEY KEY | TITLE           a table of words, which has a row in each line "@row WORD | WORD"
///   @file FILE = NAME: KEY KEY | WORDS  a file of the text or table NAME, listed with WORDS unless they are
///                                    empty; without "= NAME" one that is written elsewhere
///   @console                         what follows is the console's; "@block" begins a new part of it, and so
///                                    does what follows a table
///
/// Empty lines mean nothing. Throws std::logic_error for another line, and for a name that the document does
/// not have.
Results shown(const Document &document, const std::string &name);

} // namespace stemware::pipeline
