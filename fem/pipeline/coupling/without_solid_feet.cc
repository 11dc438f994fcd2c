#include "fem/pipeline/coupling/solid_feet.h"

#include <stdexcept>

namespace stemware::pipeline
{

bool has_solid_feet()
{
  return false;
}

std::shared_ptr<fem::Foot> make_solid_foot(const Study &, const fem::Foot *)
{
  throw std::logic_error("a solid foot is asked of a program that makes none");
}

} // namespace stemware::pipeline
