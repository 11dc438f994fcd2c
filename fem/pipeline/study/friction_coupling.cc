#include "fem/pipeline/study/friction_coupling.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

bool has_hard_table(const Study &study)
{
  return study.table.kind == TableKind::rigid || study.table.kind == TableKind::elastic;
}

} // namespace

FrictionCoupling used_friction_coupling(const Study &study)
{
  if (study.contact.friction_coupling != FrictionCoupling::automatic)
    return study.contact.friction_coupling;
  return study.contact.body == BodyKind::revolution && has_hard_table(study) ? FrictionCoupling::elastic
                                                                             : FrictionCoupling::none;
}

std::string friction_note(const Study &study)
{
  if (study.load.source != LoadSource::contact || !has_hard_table(study))
    return "";
  if (used_friction_coupling(study) == FrictionCoupling::elastic)
    return "deforms the foot: on this hard table it decides the second harmonic";
  return study.contact.body == BodyKind::solid
           ? "does not deform a solid foot; on this hard table that would decide the second harmonic"
           : "does not deform the foot; on this hard table that would decide the second harmonic";
}

std::string to_string(FrictionCoupling coupling)
{
  switch (coupling)
  {
  case FrictionCoupling::automatic:
    return "automatic";
  case FrictionCoupling::none:
    return "none";
  case FrictionCoupling::elastic:
    return "elastic";
  }
  throw std::logic_error("a friction coupling without a name");
}

} // namespace stemware::pipeline
