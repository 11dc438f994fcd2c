// A rigid flat land on a bonded layer settles like a straight strip: the width of the land is a fiftieth of
// the radius, so the curvature of the ring changes the settlement by 1e-4 only. The compliance of the hard
// interface is negligible. Reference: tests/verification/strip_on_a_layer.py.
#include "fem/contact/hard_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/reference_load.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

using stemware::ring::pi;
using namespace stemware::fem;

TEST(HardLayer, SettlementOfARigidRingAgreesWithTheSettlementOfAStrip)
{
  std::ifstream file(STEMWARE_STRIP_ON_A_LAYER);
  const auto cases = nlohmann::json::parse(file)["cases"];
  ASSERT_EQ(cases.size(), 12u);
  const double force = 1;
  for (const auto &strip : cases)
  {
    const double ratio = strip["width_over_thickness"], nu = strip["poisson_ratio"];
    RevolutionSetup setup;
    setup.foot_is_rigid = true;
    setup.profile.crown_radius = 0;
    setup.profile.land_width = setup.profile.contact_radius / 50;
    const double width = setup.profile.land_width, thickness = width / ratio;
    setup.table = { std::make_shared<HardInterface>(), Substrate{ { 0.15, thickness }, { 5e6, nu } } };
    setup.meridian.n_harmonics = 2;
    setup.n_lines = 16;
    setup.normal_force = force;
    // The zones of high pressure at the edges are about as wide as the layer is thick.
    setup.resolution.focus_size = std::min(width / 100, thickness / 2);
    setup.resolution.focus_width = width / 2;
    const MeshedRevolutionFoot foot(setup);
    const double line_load = force / (2 * pi * setup.profile.contact_radius);
    const double settlement = std::abs(foot.solve({ force, 0, 0 }).solution.motion(0));
    EXPECT_NEAR(settlement * 5e6 / (1 - nu * nu) / line_load / strip["settlement"].get<double>(), 1, 3e-3)
      << "w/h = " << ratio << ", nu = " << nu;
  }
}
