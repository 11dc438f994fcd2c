#pragma once

#include "fem/solid/body_stiffness.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// A change of body and table in one Newton step.
struct SolidIncrement
{
  using Vector = BodyStiffness::Vector;

  Vector body;                  ///< du
  Vector image;                 ///< what it takes from the body's residual, friction included
  Eigen::VectorXd displacement; ///< B du
  Eigen::Vector3d motion;       ///< of the table, scaled
  unsigned int n_iterations = 0;
  double steadiness = 1; ///< NewtonIncrement::steadiness, friction in the body aside

  void add(double factor, const SolidIncrement &other)
  {
    body.add(factor, other.body);
    image.add(factor, other.image);
    displacement += factor * other.displacement;
    motion += factor * other.motion;
  }
};

/// Friction makes Newton's matrix unsymmetric. Its symmetric part is solved, and what friction leaves of the
/// residual is solved for again, by generalised conjugate residuals (Eisenstat, Elman, Schultz, SIAM J.
/// Numer. Anal. 20 (1983) 345), until at most @p target is left.
///
/// @p increment is the solution of the symmetric part for the whole residual, @p residual what it leaves;
/// @p solve gives the increment of the symmetric part for a residual and its target, resultants left alone.
template <typename Solve>
void correct_for_friction(SolidIncrement &increment, BodyStiffness::Vector residual, double target,
                          const Solve &solve)
{
  constexpr unsigned int most_corrections = 12;
  constexpr double reduction = 0.05; // of one correction: friction is the smaller part
  std::vector<SolidIncrement> before;
  for (double left = residual.l2_norm(); left > target && before.size() < most_corrections;
       left = residual.l2_norm())
  {
    SolidIncrement next = solve(residual, std::max(reduction * left, target / 2));
    increment.n_iterations += next.n_iterations;
    for (const auto &other : before)
      next.add(-(next.image * other.image) / other.image.norm_sqr(), other);
    const double share = (residual * next.image) / next.image.norm_sqr();
    increment.add(share, next);
    residual.add(-share, next.image);
    before.push_back(std::move(next));
  }
}

} // namespace stemware::fem
