#pragma once

#include "fem/elasticity/elastic_material.h"
#include "fem/revolution/contact_compliance.h"

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Numerical parameters of the meridional problems.
struct MeridianOptions
{
  unsigned int degree = 2;       ///< of the elements, 1 to 4
  unsigned int n_harmonics = 16; ///< highest harmonic of the elastic response
  unsigned int n_threads = 0;    ///< harmonics solved at a time; 0 means as many as deal.II may use
};

/// Compliances of the contact zone (boundary id 2) of the body of revolution with the meridional section @p
/// triangulation, held at its boundary id 1 (docs/method/revolution.md, "One meridional problem per
/// harmonic").
///
/// The displacement (u_r cos, u_theta sin, u_z cos)(n theta) makes the strain a polynomial of degree one in
/// n, so that K_n = K_0 + n K_1 + n^2 K_2 is integrated once; each harmonic is factorised (Cholesky) under
/// its own conditions on the axis. Throws std::invalid_argument for a degree or a mesh that cannot be used.
ContactCompliance compute_compliance(const dealii::Triangulation<2, 2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options = {});

} // namespace stemware::fem
