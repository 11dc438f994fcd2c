#pragma once

#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"

/// Numbers of pictures that occur in reports only; see pictures.h.
namespace stemware::pipeline
{

/// Adds "foot": pressures, stresses, section and rim, if known.
void add_foot_pictures(const Study &study, const FootReport &foot, Document &document);

/// Adds "pictures" of a sweep over a grid: curves over a numerical entry, one for each value of the other
/// entry, or maps over two numerical entries with four or more values. Adds nothing for a list from a file,
/// or if no entry is numerical.
void add_sweep_pictures(const CaseList &list, const FinishedCases &finished, Document &document);

} // namespace stemware::pipeline
