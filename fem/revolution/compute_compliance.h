#pragma once

#include "fem/geometry/triangulation.h"
#include "fem/revolution/contact_compliance.h"

#include <functional>

namespace stemware::fem
{

/// Computes the compliances of the contact zone (boundary id 2) of the body of revolution with the meridional
/// section @p triangulation, fixed at boundary id 1 (docs/method/revolution.md, "One meridional problem per
/// harmonic").
///
/// The displacement (u_r cos, u_theta sin, u_z cos)(n theta) has a strain of degree one in n, so that K_n =
/// K_0 + n K_1 + n^2 K_2 is integrated once. Each harmonic is factorised (Cholesky) with its own conditions
/// on the axis, several at a time if deal.II may use threads. @p interruption is called before each harmonic,
/// from any thread; its exceptions end the work. Throws std::invalid_argument for an unusable degree or mesh.
ContactCompliance compute_compliance(const dealii::Triangulation<2, 2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options = {},
                                     const std::function<void()> &interruption = {});

} // namespace stemware::fem
