#pragma once

#include "fem/contact/interface_law.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace stemware::fem
{

/// Extent of a contact whose @p pressure(penetration [m]) [Pa] depends on the local penetration alone, that
/// of
/// @p law. @p depths: penetrations at the samples of each line of @p surface [m].
ContactExtent extent_of_lines(const ContactSurface &surface, const std::vector<Eigen::Vector3d> &depths,
                              const InterfaceLaw &law, const std::function<double(double)> &pressure);

/// Extent of a contact that is known by its nodal @p forces [N]: a node stands for its share of the area.
ContactExtent extent_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &forces);

} // namespace stemware::fem
