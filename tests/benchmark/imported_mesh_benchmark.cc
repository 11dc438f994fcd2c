// Cost of a linear solve on a mesh without a refinement history, for feet that are bodies of revolution and
// for feet with a defect.
//
//   imported_mesh_benchmark [name=value]...
//
// cells=48,2,2 (around the rim, across the land, through the foot), halvings=1, degree=2, crown=0 (a flat
// land of 2 mm), shape=foot|step, defect=none|oval|lobes|chip|off_axis|pads|wavy, width=0.95 (of an oval,
// divided by its length), modulus=1e11, moment=1.3. off_axis: the axis of the foot is 10 mm from the z axis;
// lobes: three waves of 1 µm raise and lower the whole foot; chip: 30 degrees of the edge are missing; pads:
// three sectors of 40 degrees reach the table; wavy: the land has three waves of 1 µm.
#include "fem/contact/contact_load.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/solid_body.h"
#include "ring_model/load/constants.h"
#include "tests/benchmark/solid_benchmark.h"

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <map>
#include <set>

using namespace stemware::fem;

namespace
{

constexpr double off_axis = 0.01; // distance of the foot's axis from the z axis [m]

double gap_of(const GlassProfile &profile, const std::string &defect, double x, double y)
{
  if (defect == "off_axis")
    return profile.gap(std::hypot(x - off_axis, y));
  constexpr double height_of_pads = 1e-3, amplitude = 1e-6; // [m]
  const double waves = std::cos(3 * std::atan2(y, x)), gap = profile.gap(std::hypot(x, y));
  if (defect == "pads")
    return gap + (waves < 0.5 ? height_of_pads : 0);
  return defect == "wavy" ? gap + amplitude * (1 + waves) : gap;
}

/// Copies the cells of @p drawn, changed by @p defect, to @p mesh. The copy has no refinement history, like a
/// mesh read from a file.
void import(const dealii::Triangulation<3> &drawn, const std::string &defect, double width, double radius,
            dealii::Triangulation<3> &mesh)
{
  dealii::Triangulation<3> flat;
  dealii::GridGenerator::flatten_triangulation(drawn, flat);
  flat.reset_all_manifolds();
  flat.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
  if (defect == "off_axis")
    dealii::GridTools::shift(dealii::Point<3>(off_axis, 0, 0), flat);
  else if (defect == "oval")
    dealii::GridTools::transform(
      [&](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], width * x[1], x[2]); }, flat);
  else if (defect == "lobes")
    dealii::GridTools::transform(
      [&](const dealii::Point<3> &x)
      {
        const double r = std::hypot(x[0], x[1]), theta = std::atan2(x[1], x[0]);
        return x + 1e-6 * std::pow(r / radius, 3) * std::cos(3 * theta) * dealii::Point<3>(0, 0, 1);
      },
      flat);
  if (defect != "chip")
  {
    mesh.copy_triangulation(flat);
    return;
  }
  // Chip: 30 degrees of the edge are missing, from the middle of the land outwards.
  std::set<dealii::Triangulation<3>::active_cell_iterator> removed;
  std::map<std::array<long, 3>, dealii::types::boundary_id> ids;
  const auto place_of = [](const dealii::Point<3> &x) {
    return std::array<long, 3>{ std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), std::lround(1e9 * x[2]) };
  };
  for (const auto &cell : flat.active_cell_iterators())
  {
    const dealii::Point<3> x = cell->center();
    if (std::hypot(x[0], x[1]) > radius && std::abs(std::atan2(x[1], x[0]) - 1) < stemware::ring::pi / 12)
      removed.insert(cell);
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        ids[place_of(face->center())] = face->boundary_id();
  }
  dealii::Triangulation<3> chipped;
  dealii::GridGenerator::create_triangulation_with_removed_cells(flat, removed, chipped);
  for (const auto &face : chipped.active_face_iterators())
    if (face->at_boundary())
    {
      const auto found = ids.find(place_of(face->center()));
      face->set_boundary_id(found == ids.end() ? 0 : found->second);
    }
  mesh.copy_triangulation(chipped);
}

void run(const NamedValues &values)
{
  const GlassProfile profile = profile_of(values);
  const double radius = profile.contact_radius;
  const std::vector<unsigned int> cells = values.counts("cells");
  const FootResolution resolution = { cells.at(0), cells.at(1), cells.at(2), values.count("halvings") };
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  {
    dealii::Triangulation<3> drawn;
    make_foot_mesh(profile, resolution, drawn);
    import(drawn, values.text("defect"), values.number("width"), radius, mesh);
  }
  SolidOptions options;
  options.degree = values.count("degree");
  options.straight_edges = true;
  dealii::Timer timer;
  SolidBody body(
    mesh, ElasticMaterial(), [&](double x, double y) { return gap_of(profile, values.text("defect"), x, y); },
    options);
  const double setup_seconds = timer.wall_time();
  const WinklerInterface mat(values.number("modulus"));
  const auto law = mat.make(body.contact_surface(), 0);
  const double weight = 0.3 * 9.81;
  const double x_of_axis = values.text("defect") == "off_axis" ? off_axis : 0;
  const Resultants load = { weight, 0, -weight * (values.number("moment") * radius / 2 + x_of_axis) };
  timer.restart();
  const ContactSolution solution = solve_contact(body, *law, load, radius);
  const double contact_seconds = timer.wall_time();
  const ContactLoad harmonics = extract_load(*law, solution, 8);
  fmt::print("{} unknowns, set-up {:.1f} s; contact {:.1f} s, {} steps, {} iterations; a_2/a_0 = {:.9f}, "
             "a_3/a_0 = {:.9f}\n",
             body.n_unknowns(), setup_seconds, contact_seconds, solution.n_iterations,
             solution.n_linear_iterations, harmonics.a(2) / harmonics.a(0), harmonics.a(3) / harmonics.a(0));
  ContactForces contact;
  law->evaluate(solution.normal_displacement, contact);
  body.reset();
  body.set_linear_tolerance(1e-9);
  timer.restart();
  const NewtonIncrement linear = body.solve(contact.tangent, solution.forces,
                                            prescribed_resultants(body.contact_surface(), load), { 0, 0, 0 });
  fmt::print("linear solve: {} iterations, {:.2f} s; peak memory {:.2f} GB, {:.0f} bytes per unknown\n",
             linear.linear_iterations, timer.wall_time(), peak_bytes() / 1e9,
             peak_bytes() / body.n_unknowns());
}

} // namespace

int main(int argc, char **argv)
{
  return run_benchmark(argc, argv,
                       [&]
                       {
                         run({ argc,
                               argv,
                               { { "cells", "48,2,2" },
                                 { "halvings", "1" },
                                 { "degree", "2" },
                                 { "crown", "0" },
                                 { "shape", "foot" },
                                 { "defect", "none" },
                                 { "modulus", "1e11" },
                                 { "moment", "1.3" },
                                 { "width", "0.95" } } });
                       });
}
