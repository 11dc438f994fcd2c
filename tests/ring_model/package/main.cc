// The terminal spin of the paper's glass under the moment balances of the ring model.
#include <ring_model/first_harmonic_ring.h>

#include <cmath>
#include <cstdio>

int main()
{
  using namespace stemware::ring;
  Motion motion; // 0.30 kg, led round a circle of 0.15 m at 0.35 m/s, mu = 0.30
  motion.force_offset = -0.05;
  const double radius = 0.03;

  const double omega = FirstHarmonicRing(Closure::paper, motion, radius).terminal_spin().omega;
  std::printf("moment of the centripetal force alone: %.6f rad/s\n", omega);
  std::printf("and of friction about the centre of mass: %.6f rad/s\n",
              FirstHarmonicRing(Closure::full, motion, radius).terminal_spin().omega);
  return std::abs(omega + 3.12055870152586) < 1e-12 ? 0 : 1;
}
