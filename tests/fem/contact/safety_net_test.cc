#include "fem/contact/contact_newton.h"
#include "fem/contact/pressure_law.h"
#include "fem/contact/rigid_foot.h"
#include "tests/fem/foot_case.h"

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

/// Pressure that rises from 0 to 2 @p middle within a few multiples of @p width around zero penetration.
/// Undamped Newton steps that start outside this range diverge.
struct SaturatingInterface : PressureInterface<SaturatingInterface>
{
  SaturatingInterface(double middle, double width)
      : middle(middle)
      , width(width)
  {
  }

  double stiffness_at(double) const override { throw std::logic_error("not asked for"); }
  double half_width(double, double) const override { throw std::logic_error("not asked for"); }
  double penetration_at(double) const override { throw std::logic_error("not asked for"); }
  std::shared_ptr<const InterfaceLaw> softened(double) const override
  {
    throw std::logic_error("not asked for");
  }

  double middle; ///< [Pa]
  double width;  ///< [m]

  double pressure(double depth) const { return middle * (1 + depth / std::hypot(depth, width)); }
  std::pair<double, double> pressure_and_stiffness(double depth) const
  {
    const double ratio = depth / width;
    return { pressure(depth), middle / width / std::pow(1 + ratio * ratio, 1.5) };
  }
  double cutoff_depth(double) const { return -std::numeric_limits<double>::infinity(); }
  template <typename Visitor>
  void integrate(const AreaElement &area, const Eigen::Vector3d &, const Visitor &visit) const
  {
    for_each_point(area, LineSegment{ -1, 1 }, visit);
  }
  void validate() const {}
};

} // namespace

TEST(StepLength, DampsDivergingNewtonSteps)
{
  const FootCase foot(flat_profile(), { 12, 4, 1 });
  const ContactSurface &surface = foot.body->contact_surface();
  RigidFoot rigid(surface);
  const double width = 1e-6;
  const auto law = make_law(SaturatingInterface(weight / surface.area(), width), surface);
  const LinearConditions plain = prescribed_resultants(surface, load_at(0.3));
  Eigen::Matrix3d mixing;
  mixing << 1, 0.004, -0.003, 0, 1, 0.2, 0, 0.1, 1;
  const LinearConditions mixed(surface, plain.weights() * mixing, mixing.transpose() * plain.target());
  for (const LinearConditions &conditions : { plain, mixed })
  {
    const Eigen::Vector3d pressed_in(-3 * width, 0, 0);
    const ContactStart start = { pressed_in, surface.motion_modes() * pressed_in };
    double shortest_step = 1;
    ContactControl control;
    control.progress = [&](const ContactIteration &iteration)
    { shortest_step = std::min(shortest_step, iteration.step_length); };
    const ContactSolution solution = solve_contact(rigid, *law, conditions, 0.03, control, &start);
    EXPECT_LT(plain.residual(solution.forces, solution.motion).norm(), 1e-10 * weight);
    // The solution has nearly zero penetration, because the pressure at zero penetration is N / area.
    EXPECT_LT(solution.normal_displacement.cwiseAbs().maxCoeff(), width);
    EXPECT_LT(shortest_step, 0.5);
    EXPECT_LE(solution.n_iterations, 12u);
  }
}
