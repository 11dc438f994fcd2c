#pragma once

#include "fem/contact/interface_law.h"
#include "fem/geometry/contact_cells.h"
#include "fem/geometry/elastic_material.h"

#include <memory>
#include <optional>

namespace stemware::fem
{

/// Elastic table: a thick disc under the interface.
struct Substrate
{
  TableDisc disc;
  ElasticMaterial material = { 10e9, 0.3 }; ///< hardwood
};

/// Table of a foot: an interface on a substrate.
struct Table
{
  std::shared_ptr<const InterfaceLaw> interface;
  std::optional<Substrate> substrate; ///< std::nullopt: rigid
};

} // namespace stemware::fem
