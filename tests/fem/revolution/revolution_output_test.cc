#include "fem/contact/hard_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/fem/vtu_file.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>

namespace
{

using namespace stemware::revolution_tests;
using stemware::fem_tests::FootCase;
using stemware::fem_tests::VtuFile;

VtuFile picture_of(MeshedRevolutionFoot &foot, const ContactState &state)
{
  const std::vector<FieldFile> files = foot.fields(state);
  EXPECT_EQ(files.size(), 1u);
  EXPECT_EQ(files.front().name, "contact.vtu");
  // The file must be plain XML, because ParaView's parser fails on raw bytes.
  std::istringstream text(files.front().text);
  boost::property_tree::ptree tree;
  EXPECT_NO_THROW(boost::property_tree::read_xml(text, tree));
  return VtuFile(files.front().text);
}

Eigen::Vector3d vector_at(const std::vector<double> &values, std::size_t point)
{
  return { values[3 * point], values[3 * point + 1], values[3 * point + 2] };
}

/// Returns the integrals of a scalar times 1, x and y over the plane z = @p height, which consists of lower
/// faces of quadratic cells.
Eigen::Vector3d integral_over_plane(const VtuFile &file, double height,
                                    const std::function<double(std::size_t point)> &value)
{
  // Nodes of the lower face of a Lagrange hexahedron.
  constexpr std::array<unsigned int, 9> nodes = { 0, 8, 1, 11, 24, 9, 3, 10, 2 };
  const double gauss[3] = { -std::sqrt(0.6), 0, std::sqrt(0.6) };
  const double weight[3] = { 5. / 9, 8. / 9, 5. / 9 };
  const auto shape = [](double x) { return Eigen::Vector3d(x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2); };
  const auto slope = [](double x) { return Eigen::Vector3d(x - 0.5, -2 * x, x + 0.5); };
  const std::vector<double> &points = file.array("points");
  const std::vector<double> &connectivity = file.array("connectivity");
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t cell = 0; cell < file.n_cells(); ++cell)
  {
    Eigen::Matrix<double, 9, 4> face; // columns x, y, z, value
    for (unsigned int i = 0; i < 9; ++i)
    {
      const auto point = static_cast<std::size_t>(connectivity[27 * cell + nodes[i]]);
      face.row(i) << vector_at(points, point).transpose(), value(point);
    }
    if ((face.col(2).array() - height).abs().maxCoeff() > 1e-9)
      continue;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
      {
        const auto combined = [](const Eigen::Vector3d &one, const Eigen::Vector3d &other)
        {
          const Eigen::Matrix3d product = one * other.transpose();
          return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(product.data()).eval();
        };
        const Eigen::Vector4d at = face.transpose() * combined(shape(gauss[a]), shape(gauss[b]));
        const Eigen::Vector4d first = face.transpose() * combined(slope(gauss[a]), shape(gauss[b]));
        const Eigen::Vector4d second = face.transpose() * combined(shape(gauss[a]), slope(gauss[b]));
        const double area = std::abs(first(0) * second(1) - first(1) * second(0)) * weight[a] * weight[b];
        sum += area * at(3) * Eigen::Vector3d(1, at(0), at(1));
      }
  }
  return sum;
}

} // namespace

Eigen::Vector3d moved(const VtuFile &file, std::size_t point)
{
  return vector_at(file.array("displacement"), point) + vector_at(file.array("rigid_motion"), point);
}

TEST(RevolutionFields, DisplacementsAndRigidMotionAgreeWithTheContactSolution)
{
  for (const double friction : { 0., 0.3 })
  {
    RevolutionSetup setup;
    setup.friction_coefficient = friction;
    MeshedRevolutionFoot foot(setup);
    const ContactState state = foot.solve(load_at(1.3, 0.7));
    EXPECT_EQ(state.history.size(), state.solution.n_iterations);
    EXPECT_GE(state.history.size(), 2u);
    EXPECT_LE(state.history.back().residual, 1e-8);
    const VtuFile file = picture_of(foot, state);
    const Eigen::VectorXd &normal_displacement = state.solution.normal_displacement;
    const Eigen::MatrixX2d &nodes = foot.elastic_body().contact_surface().node_position;
    unsigned int n_common = 0;
    for (std::size_t point = 0; point < file.n_points(); ++point)
    {
      const Eigen::Vector3d at = vector_at(file.array("points"), point);
      if (at(2) != 0)
        continue;
      for (Eigen::Index node = 0; node < nodes.rows(); ++node)
        if ((nodes.row(node).transpose() - at.head<2>()).norm() < 1e-8)
        {
          ++n_common;
          ASSERT_NEAR(moved(file, point)(2), normal_displacement(node),
                      1e-6 * normal_displacement.cwiseAbs().maxCoeff());

          const Eigen::Vector3d &motion = state.solution.motion;
          ASSERT_NEAR(vector_at(file.array("rigid_motion"), point)(2),
                      motion(0) + motion(1) * at(0) + motion(2) * at(1), 1e-6 * motion.norm());
        }
    }
    EXPECT_GE(n_common, 4u * 9u) << "nodes that picture and contact share";
  }
}

TEST(RevolutionFields, StressesOnACutBalanceTheLoad)
{
  // The stresses on the cut z = 3 mm balance the contact force N and the friction mu N along the motion.
  constexpr double friction = 0.3, height = 0.003;
  RevolutionSetup setup;
  setup.friction_coefficient = friction;
  setup.resolution.refinements = 1;
  MeshedRevolutionFoot foot(setup);
  const Resultants load = load_at(0.8, 0.7);
  const ContactState state = foot.solve(load);
  const VtuFile file = picture_of(foot, state);
  const auto over_cut = [&](unsigned int row, unsigned int column)
  {
    return integral_over_plane(
      file, height, [&](std::size_t point) { return file.array("stress")[9 * point + 3 * row + column]; });
  };
  const Eigen::Vector3d normal = over_cut(2, 2);
  const double drag = friction * weight, arm = weight * setup.profile.contact_radius;
  EXPECT_NEAR(normal(0) / weight, -1, 0.002);
  EXPECT_NEAR(normal(1) / arm, (load.moment_y + height * drag) / arm, 0.002);
  EXPECT_NEAR(normal(2) / arm, -load.moment_x / arm, 0.002);
  EXPECT_NEAR(over_cut(0, 2)(0) / drag, 1, 0.01);
  EXPECT_NEAR(over_cut(2, 0)(0) / drag, 1, 0.01);
  EXPECT_NEAR(over_cut(1, 2)(0) / drag, 0, 0.01);
}

TEST(RevolutionFields, PressureIntegratesToTheLoad)
{
  RevolutionSetup crowned, flat, on_hard_table;
  flat.profile.crown_radius = 0;
  on_hard_table.profile = flat_profile();
  on_hard_table.table.interface = std::make_shared<HardInterface>();
  for (const RevolutionSetup &setup : { crowned, flat, on_hard_table })
    for (const double m : { 0.5, 1.3 })
    {
      const bool is_hard = setup.table.interface->is_hard();
      if (is_hard && m > 1)
        continue;
      // The tolerance is larger on a hard table, where the pressure peaks at the inner edge of the land.
      const double tolerance = is_hard ? 0.01 : 0.006;
      MeshedRevolutionFoot foot(setup.resolved_for(weight));
      const Resultants load = load_at(m, 0.7);
      const ContactState state = foot.solve(load);
      const VtuFile file = picture_of(foot, state);
      const Eigen::Vector3d sums = integral_over_plane(
        file, 0, [&](std::size_t point) { return file.array("contact_pressure")[point]; });
      const double arm = weight * setup.profile.contact_radius;
      EXPECT_NEAR(sums(0) / weight, 1, tolerance);
      EXPECT_NEAR(sums(2) / arm, load.moment_x / arm, tolerance);
      EXPECT_NEAR(-sums(1) / arm, load.moment_y / arm, tolerance);
    }
}

TEST(RevolutionFields, AgreeWithTheSolidBody)
{
  const GlassProfile profile = flat_profile();
  RevolutionSetup setup;
  setup.profile = profile;
  setup.resolution = equal_cells(1);
  MeshedRevolutionFoot foot(setup);
  const Resultants load = load_at(0.4);
  const ContactState state = foot.solve(load);
  const VtuFile file = picture_of(foot, state);

  FootCase solid(profile, { 24, 4, 2 });
  const auto mat = make_law(WinklerInterface(1e10), solid.body->contact_surface());
  solid.solve(*mat, load);
  const VtuFile expected(
    solid.body->fields(solid.solution.motion, mat->nodal_pressure(solid.solution)).front().text);

  // Stresses are compared at r = 30 mm, away from the corners of the land.
  const auto place = [](const VtuFile &picture, std::size_t point)
  {
    const Eigen::Vector3d at = 1e6 * vector_at(picture.array("points"), point);
    return std::array<long, 3>{ std::lround(at(0)), std::lround(at(1)), std::lround(at(2)) };
  };
  std::map<std::array<long, 3>, std::size_t> places;
  for (std::size_t point = 0; point < file.n_points(); ++point)
    places[place(file, point)] = point;
  double largest_motion = 0, motion_difference = 0, largest_stress = 0, stress_difference = 0;
  unsigned int n_motions = 0, n_stresses = 0;
  for (std::size_t point = 0; point < expected.n_points(); ++point)
  {
    const auto found = places.find(place(expected, point));
    if (found == places.end())
      continue;
    const Eigen::Vector3d motion = moved(expected, point);
    largest_motion = std::max(largest_motion, motion.norm());
    motion_difference = std::max(motion_difference, (motion - moved(file, found->second)).norm());
    ++n_motions;
    const double radius = vector_at(expected.array("points"), point).head<2>().norm();
    if (std::abs(radius - 0.03) > 0.0003)
      continue;
    for (unsigned int i = 0; i < 9; ++i)
    {
      const double stress = expected.array("stress")[9 * point + i];
      largest_stress = std::max(largest_stress, std::abs(stress));
      stress_difference =
        std::max(stress_difference, std::abs(stress - file.array("stress")[9 * found->second + i]));
    }
    ++n_stresses;
  }
  EXPECT_GT(n_motions, 1000u);
  EXPECT_GT(n_stresses, 500u);
  EXPECT_LT(motion_difference / largest_motion, 4e-3);
  EXPECT_LT(stress_difference / largest_stress, 0.02);
}
