#pragma once

#include "fem/contact/interface_law.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace stemware::fem
{

/// Returns the extent of a contact from the penetrations @p depths [m] at the samples of each line of @p
/// surface, and the local law @p pressure(penetration [m]) [Pa].
ContactExtent extent_of_lines(const ContactSurface &surface, const std::vector<Eigen::Vector3d> &depths,
                              const InterfaceLaw &law, const std::function<double(double)> &pressure);

/// Returns the extent of a contact from nodal @p forces [N]; each node represents its area.
ContactExtent extent_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &forces);

} // namespace stemware::fem
