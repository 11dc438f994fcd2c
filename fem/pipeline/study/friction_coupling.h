#pragma once

#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// What Contact/Friction coupling comes to, `none` or `elastic`. On a hard table (rigid, elastic) friction
/// decides the second harmonic of a foot that does not lift off (docs/method/revolution.md), so `automatic`
/// includes it there, if the body can: a body of revolution. On a mat or a rough table it leaves it out.
FrictionCoupling used_friction_coupling(const Study &study);

/// A sentence for the terminal where the table is hard, so that friction matters for the pressure: whether
/// the study includes it. Empty elsewhere.
std::string friction_note(const Study &study);

/// "automatic", "none" or "elastic".
std::string to_string(FrictionCoupling coupling);

} // namespace stemware::pipeline
