#pragma once

#include "fem/geometry/triangulation.h"
#include "fem/revolution/contact_compliance.h"

#include <functional>

namespace stemware::fem
{

/// Computes the compliances of the contact zone (boundary id 2) of the body of revolution with the meridional
/// section @p triangulation, fixed at boundary id 1 (docs/method/revolution.md, "One meridional problem per
/// harmonic"). K_n = K_0 + n K_1 + n^2 K_2 is integrated once; each harmonic is factorised (Cholesky) with
/// its own conditions on the axis, on deal.II's threads. @p interruption is called before each harmonic, from
/// any thread; its exceptions end the work. Throws std::invalid_argument for an inadmissible degree or mesh.
ContactCompliance compute_compliance(const dealii::Triangulation<2, 2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options = {},
                                     const std::function<void()> &interruption = {});

} // namespace stemware::fem
