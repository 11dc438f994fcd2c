// The one place where the names of interface and substrate become an object, which is asked from there on.
#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/pipeline/study/study.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

std::shared_ptr<const fem::InterfaceLaw> make_interface(const TableSection &table)
{
  switch (table.interface)
  {
  case TableInterface::hard:
    return std::make_shared<fem::HardInterface>();
  case TableInterface::winkler:
    return std::make_shared<fem::WinklerInterface>(table.foundation_modulus);
  case TableInterface::rough:
    return std::make_shared<fem::RoughInterface>(table.roughness);
  }
  throw std::logic_error("a table without an interface");
}

} // namespace

fem::Table TableSection::make() const
{
  fem::Table table = { make_interface(*this), {} };
  if (substrate == TableSubstrate::elastic)
    table.substrate = fem::Substrate{ disc, disc_material };
  return table;
}

bool TableSection::is_hard() const
{
  return make().interface->is_hard();
}

} // namespace stemware::pipeline
