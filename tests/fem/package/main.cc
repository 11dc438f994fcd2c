// Computes the harmonics of the load on the rim of a wine glass: elastic foot on a mat, under weight and a
// moment.
#include <fem/revolution/meshed_revolution_foot.h>
#include <ring_model/load/constants.h>

#include <cmath>
#include <cstdio>

int main()
{
  using namespace stemware::fem;
  const double weight = 0.30 * 9.81, radius = 0.03; // [N], [m]
  RevolutionSetup setup;                            // 70 GPa, a rounded rim, a mat of 1e10 Pa/m
  setup.profile.shape = GlassShape::foot;
  MeshedRevolutionFoot foot(setup.resolved_for(weight));

  // A load a_0 + a_1 cos(theta) with this moment would be partly tensile.
  const double moment = 1.2 * weight * radius / 2;
  const ContactLoad load = foot.solve({ weight, 0, -moment }).load;
  for (unsigned int n = 0; n <= 6; ++n)
    std::printf("a_%u = %9.6f N/rad\n", n, load.a(n));

  const bool is_balanced = std::abs(2 * stemware::ring::pi * load.a(0) / weight - 1) < 1e-8 &&
                           std::abs(stemware::ring::pi * load.a(1) * load.radius() / moment - 1) < 1e-8;
  return is_balanced ? 0 : 1;
}
