// Computes the terminal spin of a glass with a user-defined load, under the paper's moment balance.
#include <ring_model/self_consistent_ring.h>
#include <ring_model/spin/answer.h>

#include <cmath>
#include <cstdio>

int main()
{
  using namespace stemware::ring;
  Motion motion; // defaults: 0.30 kg, orbit of 0.15 m at 0.35 m/s, mu = 0.30
  motion.force_offset = -0.05;
  const SelfConsistentRing ring(Closure::paper, motion, 0.03);
  const Load load([&](double omega) -> Sample { return ring.at(omega).load; });

  const double omega = answer(load, { motion }).value().omega_terminal().value();
  std::printf("terminal spin: %.6f rad/s\n", omega);
  return std::abs(omega + 3.12055870152586) < 1e-9 ? 0 : 1;
}
