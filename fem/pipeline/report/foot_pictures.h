#pragma once

#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"
#include "fem/pipeline/refinement/quantities_of_interest.h"

namespace stemware::pipeline
{

/// Adds "foot", numbers of the pictures of a foot: pressures, stresses, section and rim, if known; @p
/// bands: of the study's numbers.
void add_foot_pictures(const Study &study, const FootReport &foot, const ErrorBands &bands,
                       Document &document);

} // namespace stemware::pipeline
