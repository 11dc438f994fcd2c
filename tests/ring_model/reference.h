#pragma once

#include "ring_model/self_consistent_ring.h"
#include "ring_model/terminal_spin.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace stemware::ring
{
/// Returns ring_cases.json, 20-digit results of ring_cases.py, which shares no code with this library.
inline const nlohmann::json &reference()
{
  static const nlohmann::json cases = []
  {
    std::ifstream file(STEMWARE_RING_CASES);
    return nlohmann::json::parse(file);
  }();
  return cases;
}

inline void expect_relative(double actual, double expected, double tolerance, const std::string &what)
{
  EXPECT_LE(std::abs(actual - expected), tolerance * std::abs(expected))
    << what << ": " << ::testing::PrintToString(actual) << " instead of "
    << ::testing::PrintToString(expected);
}

namespace test
{
template <typename Ring>
TerminalSpin terminal_spin_of(const Ring &ring, const Motion &motion = {}, double radius = 0.03)
{
  SpinSearch search{ motion.orbit_speed / radius };
  search.tolerance = std::numeric_limits<double>::epsilon();
  return terminal_spin([&](double omega) { return ring.at(omega).friction.torque; }, motion.yaw_inertia,
                       search);
}

/// Uniform random numbers from a fixed seed, so that failures are reproducible.
class Numbers
{
public:
  explicit Numbers(unsigned int seed)
      : engine(seed)
  {
  }

  double between(double lower, double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(engine);
  }

  RingStack nonnegative_load(unsigned int n_harmonics, double radius = 0.03)
  {
    std::vector<double> a{ 1. }, b{ 0. };
    double sum = 0.;
    for (unsigned int n = 1; n <= n_harmonics; ++n)
    {
      a.push_back(between(-1., 1.));
      b.push_back(between(-1., 1.));
      sum += std::hypot(a[n], b[n]);
    }
    const double share = between(0., 1.) / sum;
    for (unsigned int n = 1; n <= n_harmonics; ++n)
    {
      a[n] *= share;
      b[n] *= share;
    }
    return { a, b, radius };
  }

private:
  std::mt19937 engine;
};
} // namespace test
} // namespace stemware::ring
