#pragma once

#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"

/// Numbers of pictures that reports alone have, as in pictures.h.
namespace stemware::pipeline
{

/// Adds "foot": pressures, stresses, section and rim, if known.
void add_foot_pictures(const Study &study, const FootReport &foot, Document &document);

/// Adds "pictures" of a sweep over a grid: curves over a numerical entry, one for each value of the other
/// entry, or maps over two numerical entries with four or more values. None for a list from a file and for
/// words only.
void add_sweep_pictures(const CaseList &list, const FinishedCases &finished, Document &document);

} // namespace stemware::pipeline
