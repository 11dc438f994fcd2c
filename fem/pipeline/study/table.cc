// The one place where a kind of table becomes an object, which is asked from there on.
#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/pipeline/study/study.h"

#include <stdexcept>

namespace stemware::pipeline
{

fem::Table TableSection::make() const
{
  switch (kind)
  {
  case TableKind::rigid:
    return { std::make_shared<fem::HardInterface>(), {} };
  case TableKind::mat:
    return { std::make_shared<fem::WinklerInterface>(foundation_modulus), {} };
  case TableKind::rough:
    return { std::make_shared<fem::RoughInterface>(roughness), {} };
  case TableKind::elastic:
    return { std::make_shared<fem::HardInterface>(), fem::Substrate{ disc, disc_material } };
  }
  throw std::logic_error("a table without an interface");
}

bool TableSection::is_hard() const
{
  return make().interface->is_hard();
}

} // namespace stemware::pipeline
