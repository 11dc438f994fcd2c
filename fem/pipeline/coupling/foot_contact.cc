#include "fem/pipeline/coupling/foot_contact.h"

#include <stdexcept>

namespace stemware::pipeline
{

std::unique_ptr<FootContact> make_foot_contact(const Study &study, fem::ComplianceStore &store)
{
  switch (study.contact.body)
  {
  case BodyKind::solid:
    return make_solid_contact(study);
  case BodyKind::revolution:
    return make_revolution_contact(study, store);
  }
  throw std::logic_error("a body without a contact");
}

} // namespace stemware::pipeline
