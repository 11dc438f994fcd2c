// `stemware slide`: bodies that are pushed and let go, against closed forms.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::test
{
namespace
{

/// The part "slide" of the summary of a slide with these arguments.
nlohmann::json slide_of(const std::vector<std::string> &arguments)
{
  const ScratchFolder scratch;
  std::vector<std::string> command = { "slide", "--output", "slid", "--quiet" };
  command.insert(command.end(), arguments.begin(), arguments.end());
  const Ended ended = stemware(scratch, command);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return ended.exit_code == 0 ? read_summary(scratch / "slid")["slide"] : nlohmann::json();
}

} // namespace

TEST(SlideVerb, RingAndDiscEndWhereTheLiteratureSays)
{
  const nlohmann::json ring = slide_of({ "--body", "ring", "--spin", "7 rad/s" });
  EXPECT_NEAR(ring["final_slip_ratio"].get<double>(), 1, 1e-12); // duality, any start
  EXPECT_LT(ring["energy_error"].get<double>(), 1e-9);
  EXPECT_EQ(ring["stop"]["y"], 0.);
  EXPECT_EQ(ring["stop"]["heading"], 0.);
  EXPECT_TRUE(ring["mesh_change"].is_null()); // closed forms
  const nlohmann::json disc = slide_of({ "--body", "disc", "--spin", "-7 rad/s" });
  EXPECT_NEAR(disc["final_speed_over_rim_speed"].get<double>(), -0.6530017892055976, 1e-12); // published
  EXPECT_LT(disc["energy_error"].get<double>(), 1e-9);
  // tests/ring_model/ring_cases.json, inner over outer radius 0.5.
  const nlohmann::json annulus = slide_of({ "--body", "annulus", "--inner-radius", "15 mm" });
  EXPECT_NEAR(annulus["final_speed_over_rim_speed"].get<double>(), 0.7744688699130702, 1e-12);
}

TEST(SlideVerb, WithoutSpinAnyBodyIsABrick)
{
  // v_0^2 / (2 mu g), v_0 / (mu g); the pressure's shape does not matter.
  for (const char *body : { "glass", "ring", "disc" })
  {
    const nlohmann::json slide = slide_of({ "--body", body, "--spin", "0", "--speed", "50 cm/s" });
    EXPECT_NEAR(slide["stop"]["x"].get<double>(), 0.25 / (2 * 0.3 * 9.81), 1e-9) << body;
    EXPECT_NEAR(slide["stop"]["time"].get<double>(), 0.5 / (0.3 * 9.81), 1e-9) << body;
    EXPECT_NEAR(slide["stop"]["y"].get<double>(), 0, 1e-9) << body;
    EXPECT_EQ(slide["final_slip_ratio"], 0.) << body;
  }
}

TEST(SlideVerb, ATiltedRingDriftsByTheClosedForm)
{
  // a_y = -mu^2 g (h / R) eps for slow spin; with this inertia eps stays, and y = -eps (h / R) v_0^2 / (4 g).
  const double mu = 0.2, ratio = 1. / 3, eps = 0.03 * 0.01;
  const double inertia = 0.3 * 0.03 * 0.03 * (0.5 - std::pow(mu * ratio, 2));
  const nlohmann::json slide =
    slide_of({ "--body", "ring", "--spin", "0.01 rad/s", "--set", "Motion/Friction coefficient=0.2", "--set",
               "Motion/Centre of mass height=10 mm", "--set",
               "Motion/Yaw inertia=" + nlohmann::json(inertia).dump() });
  EXPECT_NEAR(slide["start"]["acceleration_to_the_left"].get<double>() / (-mu * mu * 9.81 * ratio * eps), 1,
              1e-6);
  EXPECT_NEAR(slide["stop"]["y"].get<double>() / (-eps * ratio / (4 * 9.81)), 1, 1e-5);
  EXPECT_TRUE(slide["stop"]["heading"].is_null()); // it turns on while the speed vanishes
}

TEST(SlideVerb, AGlassOnARigidRimIsTheRing)
{
  // The paper's load for the glass: a first harmonic on the contact radius in balance with the friction's
  // moment, which is the ring of the same height and inertia, by code that knows no balance of moments.
  const std::vector<std::string> both = { "--set", "Load/Source=first harmonic",
                                          "--set", "Motion/Centre of mass height=20 mm",
                                          "--set", "Motion/Yaw inertia=3e-4" };
  std::vector<std::string> glass = both, ring = both;
  ring.insert(ring.end(), { "--body", "ring" });
  const nlohmann::json one = slide_of(glass), other = slide_of(ring);
  for (const char *key : { "x", "y", "time", "yaw_angle", "distance" })
    EXPECT_NEAR(one["stop"][key].get<double>(), other["stop"][key].get<double>(), 1e-8) << key;
  EXPECT_NEAR(one["final_slip_ratio"].get<double>(), other["final_slip_ratio"].get<double>(), 1e-10);
  EXPECT_NEAR(one["largest_moment_ratio"].get<double>(), other["largest_moment_ratio"].get<double>(), 1e-8);
}

TEST(SlideVerb, TheGlassOnItsOwnFootBendsLikeTheRing)
{
  // A narrow contact on a stiff mat: close to the ring, and its mirror image with the spin reversed.
  const std::vector<std::string> low = { "--set", "Motion/Centre of mass height=20 mm", "--set",
                                         "Motion/Yaw inertia=3e-4" };
  std::vector<std::string> left = low, ring = low;
  left.insert(left.end(), { "--spin", "-20 rad/s" });
  ring.insert(ring.end(), { "--body", "ring" });
  const nlohmann::json glass = slide_of(low), mirrored = slide_of(left), thin = slide_of(ring);
  const double y = glass["stop"]["y"];
  EXPECT_LT(y, -1e-3);
  EXPECT_NEAR(mirrored["stop"]["y"].get<double>(), -y, 1e-7);
  EXPECT_NEAR(y / thin["stop"]["y"].get<double>(), 1, 0.05);
  EXPECT_NEAR(glass["final_slip_ratio"].get<double>(), thin["final_slip_ratio"].get<double>(), 0.02);
  EXPECT_LT(glass["energy_error"].get<double>(), 1e-9);
  EXPECT_TRUE(glass["stop"]["heading"].is_null());
  EXPECT_GT(glass["mesh_change"].get<double>(), 1e-12);
  EXPECT_LT(glass["mesh_change"].get<double>(), 1e-5);
}

TEST(SlideVerb, LeavesTablesAndAReportWithThePath)
{
  const ScratchFolder scratch;
  const Ended ended =
    stemware(scratch, { "slide", "--body", "ring", "--set", "Motion/Centre of mass height=2 cm", "--set",
                        "Motion/Orbit speed=0.2", "--json" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.err.find("Motion/Orbit speed has no effect"), std::string::npos) << ended.err;
  const nlohmann::json line = nlohmann::json::parse(ended.out);
  const auto folder = scratch / "results/default-slide";
  EXPECT_LT(line["drift"].get<double>(), 0);
  const std::string page = read_text(folder / "report.html");
  for (const char *figure : { "path", "drift", "speeds", "slip_ratio", "energy" })
    EXPECT_NE(page.find(std::string("<figure id=\"") + figure), std::string::npos) << figure;
  EXPECT_NE(page.find("to the right"), std::string::npos);
  EXPECT_NE(read_text(folder / "path.csv").find("friction loss"), std::string::npos);
}

TEST(SlideVerb, RefusesWhatCannotSlide)
{
  const ScratchFolder scratch;
  const auto refused = [&](std::vector<std::string> arguments, const std::string &why, int exit_code = 1)
  {
    arguments.insert(arguments.begin(), "slide");
    const Ended ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, exit_code) << why;
    EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  };
  refused({ "--body", "cup" }, "cup is not allowed; give glass, ring, annulus or disc");
  refused({ "--speed", "0" }, "--speed = 0 is not allowed; give a speed");
  refused({ "--speed", "3 kg" }, "--speed = 3 kg is a mass");
  refused({ "--spin", "fast" }, "--spin = fast is not allowed");
  refused({ "--body", "annulus" }, "--inner-radius = 0 m");
  refused({ "--body", "annulus", "--inner-radius", "40 mm" }, "outer radius");
  refused({ "--body", "disc", "--inner-radius", "10 mm" }, "belongs to --body annulus");
  refused({ "--set", "Motion/Friction law=Stribeck" }, "Motion/Friction law = Coulomb");
  refused({ "--set", "Load/Moment ratio=0.3" }, "moment of its friction");
  refused({ "--set", "Motion/Centre of mass height=12 cm" }, "tips");
  refused({ "--body", "ring", "--set", "Motion/Centre of mass height=12 cm" }, "tips over", 2);
  EXPECT_TRUE(names_in(scratch.path()).empty());
}

} // namespace stemware::test
