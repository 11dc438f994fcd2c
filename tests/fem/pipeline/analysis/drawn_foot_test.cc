#include "fem/pipeline/study/study_file.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace stemware::pipeline
{
namespace
{

std::string forty_points()
{
  const fem::GlassProfile glass = Study().glass.profile;
  const fem::Fillet fillet = glass.fillet();
  std::string points = "r (m), z (m)\n";
  const auto add = [&](double radius, double height)
  { points += fmt::format("{:.12g}, {:.12g}\n", radius, height); };
  for (unsigned int i = 0; i < 18; ++i)
    add(glass.land_inner_radius() * i / 18, glass.underside(glass.land_inner_radius() * i / 18));
  add(glass.land_inner_radius(), 0);
  for (unsigned int i = 0; i < 4; ++i)
  {
    const double radius = glass.land_outer_radius() + (glass.foot_radius - glass.land_outer_radius()) * i / 3;
    add(radius, glass.underside(radius));
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double radius = glass.foot_radius + (fillet.end_radius - glass.foot_radius) * i / 3;
    add(radius, glass.topside(radius));
  }
  constexpr unsigned int n_arc = 12;
  const double begin = std::asin((fillet.end_radius - fillet.centre_radius) / fillet.radius);
  for (unsigned int i = 0; i < n_arc; ++i)
  {
    // Angle from the downward direction, negative towards the stem [rad].
    const double angle = begin + (-ring::pi / 2 - begin) * i / (n_arc - 1);
    add(fillet.centre_radius + fillet.radius * std::sin(angle),
        fillet.centre_height - fillet.radius * std::cos(angle));
  }
  add(glass.stem_radius, glass.height());
  add(0, glass.height());
  return points;
}

TEST(DrawnFoot, SpinsLikeTheFootItWasDrawnFromAndUnlikeAThinnerFoot)
{
  const test::ScratchFolder scratch;
  const std::string points = forty_points();
  ASSERT_EQ(std::count(points.begin(), points.end(), '\n'), 1 + 40);
  const std::string file = scratch.write("foot.csv", points);
  for (const std::string table : { "Winkler", "hard" })
  {
    const std::string interface = "Table/Interface=" + table;
    const test::SolvedStudy foot(read_study("", { interface }));
    const test::SolvedStudy drawn(read_study(
      "", { interface, "Glass/Shape=profile", "Glass/Profile file=" + file, "Glass/Crown radius=0.003" }));
    EXPECT_NEAR(drawn.omega() / foot.omega(), 1, 1e-4) << table;
    // The spin is sensitive to the shape: a thinner foot changes the spin more than twice as much as the
    // drawn profile does.
    const test::SolvedStudy thinner(read_study("", { interface, "Glass/Foot thickness=0.003" }));
    EXPECT_GT(std::abs(thinner.omega() / foot.omega() - 1), 2 * std::abs(drawn.omega() / foot.omega() - 1))
      << table;
  }
}

} // namespace
} // namespace stemware::pipeline
