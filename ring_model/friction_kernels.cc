#include "ring_model/friction_kernels.h"

#include "ring_model/load/require.h"

#include <boost/math/special_functions/ellint_rd.hpp>

#include <cmath>

namespace stemware::ring
{
namespace
{
/// Laplace coefficient Q_n(eps) of order n, scaled to q_n = eps^-n Q_n, and g_n = q_{n-1} - q_n. Here eps is
/// the smaller of rim speed and sliding speed, divided by the larger.
struct Pair
{
  double q;
  double g;
};

/// Returns q_1 = 4 D and g_1 = 4 B (Legendre's elliptic integrals) for @p complement = 1 - eps^2.
Pair first_pair(double complement)
{
  if (complement <= 0.)
    return { 0., 4. }; // |eps| = 1: the kernels contain only (1 - eps^2) q_n = 0
  return { 4. / 3. * boost::math::ellint_rd(0., complement, 1.),
           4. / 3. * complement * boost::math::ellint_rd(0., 1., complement) };
}

/// Returns the pair of order @p n >= 1 from @p above, the pair of order n + 1, without cancellation.
Pair step_down(const Pair &above, unsigned int n, double eps_squared, double complement)
{
  const double inverse = 1. / (2. * n - 1.), feed = complement * inverse;
  return { above.q + above.g, ((2. * n + 1.) * inverse * eps_squared + feed) * above.g + feed * above.q };
}

/// Returns the pair of order n + 1 from @p below. The result g loses digits unless n (1 - eps^2) is small.
Pair step_up(const Pair &below, unsigned int n, double eps_squared, double complement)
{
  const double g = ((2. * n - 1.) * below.g - complement * below.q) / ((2. * n + 1.) * eps_squared);
  return { below.q - g, g };
}

/// Computes the pairs n = 1...@p n_max into q = values[3 n] and g = values[3 n + 1]. Returns the pair of
/// order n_max + 1.
///
/// Rounding errors of the upward recurrence grow like eps^{-2n}, which is harmless only close to |eps| = 1.
/// For smaller |eps| the recurrence runs downwards from an arbitrary pair, at an order so high that this pair
/// has no effect. The result is then scaled so that the pair of order 1 equals @p first.
Pair fill_pairs(double *values, unsigned int n_max, const Pair &first, double eps, double complement)
{
  const double eps_squared = eps * eps;
  const auto store = [values](unsigned int n, const Pair &pair)
  {
    values[3 * n] = pair.q;
    values[3 * n + 1] = pair.g;
  };
  if ((n_max + 1.) * complement < 2.5 && eps_squared > 0.5)
  {
    Pair pair = first;
    for (unsigned int n = 1; n <= n_max; ++n)
    {
      store(n, pair);
      pair = step_up(pair, n, eps_squared, complement);
    }
    return pair;
  }

  const double decay = eps > 0. ? -std::log(eps) : HUGE_VAL;
  unsigned int n = n_max + 4 + static_cast<unsigned int>(18. / decay);
  Pair pair{ 1., 0.5 / n };
  for (--n; n > n_max; --n)
    pair = step_down(pair, n, eps_squared, complement);
  const Pair beyond = pair;
  for (; n >= 1; --n)
  {
    pair = step_down(pair, n, eps_squared, complement);
    store(n, pair);
  }
  const double scale = first.q / pair.q;
  for (unsigned int k = 1; k <= n_max; ++k)
    store(k, { values[3 * k] * scale, values[3 * k + 1] * scale });
  return { beyond.q * scale, beyond.g * scale };
}
} // namespace

FrictionKernels::FrictionKernels(double rim_speed, double speed, unsigned int n_max)
    : highest(n_max)
    , values(3 * (n_max + 1))
{
  require_finite(rim_speed, "the rim speed omega R");
  require(std::isfinite(speed) && speed >= 0., "the sliding speed is ", speed,
          " m/s, but must be finite and not negative: the slip frame points along the motion");
  const double rim = std::abs(rim_speed);
  require(
    rim > 0. || speed > 0.,
    "the ring neither slides nor spins (v = 0, omega R = 0): the direction of kinetic friction is undefined");

  const bool fast_spin = rim > speed;
  const double slow = fast_spin ? speed : rim, fast = fast_spin ? rim : speed;
  const double ratio = slow / fast;
  evaluate_slow_spin(ratio, (fast - slow) / fast * (1. + ratio), fast_spin);
  if (fast_spin) // duality: torque and drag of eps are minus drag and torque of 1 / eps
  {
    values[0] /= ratio;
    for (unsigned int n = 0; n <= highest; ++n)
    {
      const double torque = -values[3 * n + 2];
      values[3 * n + 2] = -values[3 * n + 1];
      values[3 * n + 1] = torque;
    }
  }
  for (unsigned int n = 0; n <= highest && rim_speed < 0.; ++n) // parity in eps
    if (n % 2 == 0)
      values[3 * n + 1] = -values[3 * n + 1];
    else
    {
      values[3 * n] = -values[3 * n];
      values[3 * n + 2] = -values[3 * n + 2];
    }
}

void FrictionKernels::evaluate_slow_spin(double eps, double complement, bool divided)
{
  const double eps_squared = eps * eps;
  // `values` contains q and g of each order n until the loop below replaces them by the kernels P_n and K_n.
  const Pair first = first_pair(complement);
  const Pair beyond = fill_pairs(values.data(), highest, first, eps, complement);

  double power = 1.; // eps^{n-1}
  for (unsigned int n = 1; n <= highest; ++n)
  {
    const double q = complement * values[3 * n], g = values[3 * n + 1];
    const double g_above = n < highest ? values[3 * n + 4] : beyond.g;
    values[3 * n] = -power * (divided ? 1. : eps) * (q + 2. * g) / (2. * n + 1.);
    values[3 * n + 1] = power * ((n + 1.) * q + g) / (2. * n + 1.);
    values[3 * n + 2] = power * eps * ((n - 1.) * q - eps_squared * g_above) / (2. * n - 1.);
    power *= eps;
  }
  values[0] = (1. + eps_squared) * first.g + complement * first.q;
  values[1] = -eps * first.g;
  values[2] = first.g + complement * first.q;
}
} // namespace stemware::ring
