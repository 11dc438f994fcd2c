#include "fem/contact/contact_demand.h"
#include "fem/revolution/gap_gradient.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::revolution_tests
{

namespace
{

/// A crowned foot on a mat that slides, presses with a moment of its own friction, and leans; contact is lost
/// on a part of the rim.
struct SlidingFoot
{
  explicit SlidingFoot(double modulus)
      : profile(GlassProfile())
      , body(foot_compliance(profile, graded_cells()), flat_gap(), 64)
      , law(make_law(WinklerInterface(modulus), body.contact_surface()))
  {
    body.set_sliding(SlidingTraction{ 0.4, 20 });
    demand = load_at(0.9, 0.7);
    demand.ring_radii = { 0.0295, 0.0305 };
    // Any linear function of the load serves as the moment of friction.
    demand.friction_x = { { { 0, 2e-3, 1e-3 }, { 1e-3, 0, 0 } }, { { 0, 1e-3, 0 }, { 0, -1e-3, 2e-3 } } };
    demand.friction_y = { { { 1e-3, 0, 0 }, { 0, 1e-3, 0 } }, { { 0, 3e-3, 0 }, { 0, 1e-3, 1e-3 } } };
    demand.tilt_moment = 0.1 * weight;
  }

  BodyOfRevolution::Gap flat_gap() const
  {
    return [profile = profile](double r, double) { return profile.gap(r); };
  }

  LinearConditions conditions() const { return conditions_of(body.contact_surface(), demand); }

  ContactSolution solve()
  {
    ContactControl control;
    control.tolerance = control.equilibrium_tolerance = 1e-13;
    control.set_matters = false;
    const ContactSolution even = solve_contact(body, *law, load_at(0), profile.contact_radius);
    const ContactStart start = from(even);
    return solve_contact(body, *law, conditions(), profile.contact_radius, control, &start);
  }

  GlassProfile profile;
  BodyOfRevolution body;
  std::unique_ptr<TableLaw> law;
  ContactDemand demand;
};

} // namespace

// Oracle: differences of contacts that are solved with another gap.
TEST(GapGradient, IsTheChangeOfContactsWithAnotherGap)
{
  for (const double modulus : { 1e10, 1e13 })
  {
    SCOPED_TRACE(modulus);
    SlidingFoot foot(modulus);
    const ContactSolution solution = foot.solve();
    const ContactSurface &surface = foot.body.contact_surface();
    ForceFunction function;
    function.of_forces = (3 * surface.node_position.col(0) + surface.node_position.col(1)).array().sin() +
                         surface.node_position.rowwise().norm().array() * 40;
    function.of_motion = { 100, -2, 3 };
    ContactForces contact;
    foot.law->evaluate(solution.normal_displacement, contact);
    const GapGradient gradient = gap_gradient(foot.body, contact.tangent, foot.conditions(), function);

    const auto change = [&](double r, double theta)
    { return (1 + 300 * (r - 0.03)) * (std::cos(2 * theta - 0.4) + 0.3 * std::sin(5 * theta)); };
    const double amplitude = 1e-4 * -(surface.node_gap + solution.normal_displacement).minCoeff();
    const auto value_at = [&](double share)
    {
      foot.body.set_gap([&](double r, double theta)
                        { return foot.profile.gap(r) + share * amplitude * change(r, theta); });
      const ContactSolution changed = foot.solve();
      return function.of_forces.dot(changed.forces) + function.of_motion.dot(changed.motion);
    };
    const double by_differences = (value_at(1) - value_at(-1)) / 2;
    double by_gradient = 0;
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      by_gradient += gradient.of_gap.reshaped()(i) * amplitude *
                     change(surface.node_position.row(i).norm(),
                            std::atan2(surface.node_position(i, 1), surface.node_position(i, 0)));
    EXPECT_NEAR(by_gradient, by_differences, 1e-4 * std::abs(by_differences));
    EXPECT_GT(std::abs(by_differences), 1e-12);
  }
}

// Oracle: contacts under another normal force.
TEST(GapGradient, KnowsTheChangeWithTheConditions)
{
  SlidingFoot foot(1e10);
  const ContactSolution solution = foot.solve();
  ForceFunction function;
  function.of_forces = foot.body.contact_surface().node_position.col(0).array().cos();
  function.of_motion = { 100, -2, 3 };
  ContactForces contact;
  foot.law->evaluate(solution.normal_displacement, contact);
  const GapGradient gradient = gap_gradient(foot.body, contact.tangent, foot.conditions(), function);
  const auto value_at = [&](double share)
  {
    foot.demand.normal_force = weight * (1 + share);
    const ContactSolution changed = foot.solve();
    return function.of_forces.dot(changed.forces) + function.of_motion.dot(changed.motion);
  };
  const double by_differences = (value_at(1e-4) - value_at(-1e-4)) / 2e-4;
  EXPECT_NEAR(weight * gradient.of_conditions(0), by_differences, 1e-4 * std::abs(by_differences));
}

} // namespace stemware::revolution_tests
