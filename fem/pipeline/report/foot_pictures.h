#pragma once

#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"

namespace stemware::pipeline
{

/// Adds "foot", numbers of the pictures of a foot: pressures, stresses, section and rim, if known.
void add_foot_pictures(const Study &study, const FootReport &foot, Document &document);

} // namespace stemware::pipeline
