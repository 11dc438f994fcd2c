#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/meridian_mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <random>

using namespace stemware::fem;

namespace
{

struct RandomSection
{
  GlassProfile profile;
  MeridianResolution resolution;
  unsigned int degree = 2;
  TableDisc disc;
};

/// Returns a random section: the land is 0.5 to 4 mm wide, the foot up to six times as thick. In most
/// sections, up to twelve halvings refine the cells towards a narrow strip of the land (focus).
RandomSection random_section(unsigned int seed)
{
  std::mt19937 engine(seed);
  const auto between = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(engine); };
  const auto one_of = [&](unsigned int low, unsigned int high)
  { return std::uniform_int_distribution<unsigned int>(low, high)(engine); };
  for (;;)
    try
    {
      RandomSection section;
      GlassProfile &profile = section.profile;
      profile.shape = one_of(0, 1) == 0 ? GlassShape::step : GlassShape::foot;
      profile.land_width = between(0.0005, 0.004);
      profile.foot_thickness = profile.land_width * between(1, 6);
      profile.contact_radius = between(0.025, 0.040);
      profile.foot_radius = profile.contact_radius + profile.land_width / 2 + between(0.0005, 0.006);
      profile.land_height = between(0.0003, 0.002);
      profile.edge_thickness = between(0.001, 0.003);
      profile.validate();
      MeridianResolution &resolution = section.resolution;
      resolution.land_cells = 2 * one_of(1, 4);
      resolution.land_grading = between(1, 3);
      resolution.refinements = one_of(0, 1);
      const unsigned int n_halvings = one_of(0, 12);
      if (n_halvings > 0)
      {
        resolution.focus_size =
          profile.land_width / resolution.land_cells / std::pow(2, between(0, n_halvings));
        resolution.focus_radius = one_of(0, 2) == 0
                                    ? profile.land_inner_radius()
                                    : between(profile.land_inner_radius(), profile.land_outer_radius());
        resolution.focus_width = resolution.focus_size * between(0, 12);
        resolution.focus_growth = between(1.4, 2.2);
      }
      section.degree = one_of(1, 4);
      section.disc.thickness = between(0.001, 0.050);
      return section;
    }
    catch (const std::invalid_argument &)
    {
    }
}

std::vector<double> contact_nodes(const dealii::Triangulation<2> &triangulation, unsigned int degree)
{
  const dealii::FE_Q<2> element(degree);
  dealii::DoFHandler<2> dofs(triangulation);
  dofs.distribute_dofs(element);
  std::vector<dealii::Point<2>> points(dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ<2>(degree), dofs, points);
  std::vector<double> radii;
  for (const auto dof : dealii::DoFTools::extract_boundary_dofs(
         dofs, {}, { static_cast<dealii::types::boundary_id>(FootBoundary::contact_zone) }))
    radii.push_back(points[dof][0]);
  std::sort(radii.begin(), radii.end());
  return radii;
}

struct Shape
{
  double worst = 0;            ///< largest aspect ratio of all cells
  double worst_of_contact = 0; ///< largest aspect ratio of the cells on the contact zone
};

/// Returns the largest aspect ratios, which are infinite if a cell is inverted.
Shape shape_of(const dealii::Triangulation<2> &triangulation, unsigned int degree)
{
  const dealii::Vector<double> ratios = dealii::GridTools::compute_aspect_ratio_of_cells(
    dealii::MappingQ<2>(degree), triangulation, dealii::QGauss<2>(degree + 1));
  Shape shape;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const double ratio = ratios[cell->active_cell_index()];
    shape.worst = std::max(shape.worst, ratio);
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == static_cast<unsigned int>(FootBoundary::contact_zone))
        shape.worst_of_contact = std::max(shape.worst_of_contact, ratio);
  }
  return shape;
}

} // namespace

TEST(ContactCells, AreWellShapedAndSharedByFootAndDisc)
{
  for (unsigned int seed = 1; seed <= 100; ++seed)
  {
    const RandomSection section = random_section(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    dealii::Triangulation<2> foot;
    dealii::Triangulation<2> disc;
    make_meridian_mesh(section.profile, section.resolution, foot);
    make_meridian_mesh(section.disc, section.profile, section.resolution, disc);
    const std::vector<double> above = contact_nodes(foot, section.degree);
    const std::vector<double> below = contact_nodes(disc, section.degree);

    const std::vector<double> borders = contact_cells(section.profile, section.resolution).borders;
    const unsigned int nodes_per_cell = section.degree << section.resolution.refinements;
    ASSERT_EQ(above.size(), nodes_per_cell * (borders.size() - 1) + 1);
    ASSERT_EQ(below.size(), above.size());
    const double rounding = 1e-14 * section.profile.contact_radius;
    for (std::size_t i = 0; i < above.size(); ++i)
      ASSERT_NEAR(above[i], below[i], rounding);
    for (std::size_t i = 0; i < borders.size(); ++i)
      ASSERT_NEAR(above[i * nodes_per_cell], borders[i], rounding);

    for (const auto *mesh : { &foot, &disc })
    {
      const Shape shape = shape_of(*mesh, section.degree);
      EXPECT_TRUE(std::isfinite(shape.worst));
      if (!section.resolution.has_focus())
        continue; // the cells of a graded land may be elongated
      EXPECT_LT(shape.worst_of_contact, 5);
      // In a disc, columns of narrow cells extend from the focus to the bottom. Elongated cells do no harm
      // there, because the solution hardly varies along r.
      EXPECT_LT(shape.worst, mesh == &foot ? 400 : 2000);
    }
  }
}

TEST(ContactCells, HaveTheRequestedSizeInTheFocusAndGrowGraduallyOutside)
{
  const GlassProfile profile;
  for (const double half_width : { 0.9e-6, 2.5e-6, 1e-5, 1.7e-4 })
  {
    MeridianResolution resolution;
    resolution.focus_size = half_width / 4;
    resolution.focus_width = 3 * half_width;
    const std::vector<double> borders = contact_cells(profile, resolution).borders;
    unsigned int n_in_focus = 0;
    double before = 0;
    for (std::size_t i = 1; i < borders.size(); ++i)
    {
      const double size = borders[i] - borders[i - 1];
      const double distance = std::abs((borders[i] + borders[i - 1]) / 2 - profile.contact_radius);
      if (distance < resolution.focus_width)
      {
        EXPECT_NEAR(size / resolution.focus_size, 1, 1e-8);
        ++n_in_focus;
      }
      if (before > 0)
      {
        // Factor 2 by halving, and up to 1.5 because the cells at the borders of the land absorb a remainder.
        EXPECT_LT(std::max(size / before, before / size), 3 * (1 + 1e-9));
      }
      before = size;
    }
    EXPECT_EQ(n_in_focus, 24u) << half_width;
    // The cell size doubles repeatedly, so the number of cells grows logarithmically.
    EXPECT_LT(borders.size(), 24 + 6 * std::log2(profile.land_width / resolution.focus_size));
  }
}

TEST(ContactCells, RefuseTooManyCellsNoGrowthAndAFocusOutsideTheLand)
{
  MeridianResolution outside;
  outside.focus_size = 1e-4;
  outside.focus_radius = 0.02;
  EXPECT_THROW(contact_cells(GlassProfile(), outside), std::invalid_argument);
  MeridianResolution too_many;
  too_many.focus_size = 1e-8;
  too_many.focus_width = 1e-3;
  EXPECT_THROW(contact_cells(GlassProfile(), too_many), std::invalid_argument);
  MeridianResolution shrinking;
  shrinking.focus_growth = 1;
  EXPECT_THROW(shrinking.validate(), std::invalid_argument);
}
