#include <ring_model/first_harmonic_ring.h>

#include <cmath>
#include <cstdio>

int main()
{
  using namespace stemware::ring;
  const double omega = FirstHarmonicRing(Closure::paper, Motion(), 0.03).terminal_spin().omega;
  std::printf("terminal spin %.14f rad/s\n", omega);
  return std::abs(omega + 3.12055870152586) < 1e-12 ? 0 : 1;
}
