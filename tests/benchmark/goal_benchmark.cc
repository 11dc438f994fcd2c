// Goal-oriented meshes of a solid foot, for a_2 / a_0 of the load at rest, compared with uniformly refined
// meshes: unknowns, error relative to a body of revolution, and estimated error.
//
//   goal_benchmark [name=value]...
//
// cells=48,2,2 (around the rim, across the land, through the foot), refinements=1 (of the first adaptive
// mesh), uniform=2 (maximum number of uniform refinements), meshes=6 (adaptive meshes), most=2000000 (maximum
// number of unknowns), share=0.8 (fraction of the error in the halved cells), degree=2, crown=0.003 (0: a
// flat land of 2 mm), shape=step|foot, table=winkler|hard, modulus=1e11, moment=1.2, friction=0, exact=
// (known reference value instead of a body of revolution).
#include "fem/contact/hard_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/solid_foot.h"
#include "ring_model/load/constants.h"
#include "tests/benchmark/solid_benchmark.h"

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>

#include <optional>

using namespace stemware::fem;

namespace
{

struct Case
{
  SolidSetup solid;
  RevolutionSetup revolution;
  FootResolution resolution;
  ContactDemand demand;
  stemware::ring::Slip slip = { 10, {} };
  unsigned int max_refinements = 2;
  unsigned int n_meshes = 6;
  unsigned int max_unknowns = 2000000;
  double share = 0.8;
  std::optional<double> exact;
};

Case read_case(int argc, char **argv)
{
  const NamedValues values(argc, argv,
                           { { "cells", "48,2,2" },
                             { "refinements", "1" },
                             { "uniform", "2" },
                             { "meshes", "6" },
                             { "most", "2000000" },
                             { "share", "0.8" },
                             { "degree", "2" },
                             { "crown", "0.003" },
                             { "shape", "step" },
                             { "table", "winkler" },
                             { "modulus", "1e11" },
                             { "exact", "" },
                             { "moment", "1.2" },
                             { "friction", "0" } });
  Case study;
  const std::vector<unsigned int> cells = values.counts("cells");
  study.resolution = { cells.at(0), cells.at(1), cells.at(2), values.count("refinements") };
  study.max_refinements = values.count("uniform");
  study.n_meshes = values.count("meshes");
  study.max_unknowns = values.count("most");
  study.share = values.number("share");
  if (!values.text("exact").empty())
    study.exact = values.number("exact");
  const GlassProfile profile = profile_of(values);
  study.solid.profile = study.revolution.profile = profile;
  std::shared_ptr<const InterfaceLaw> interface =
    std::make_shared<WinklerInterface>(values.number("modulus"));
  if (values.text("table") == "hard")
    interface = std::make_shared<HardInterface>();
  study.solid.table.interface = study.revolution.table.interface = interface;
  study.solid.friction_coefficient = study.revolution.friction_coefficient = values.number("friction");
  study.solid.options.degree = values.count("degree");
  study.solid.options.linear_solver = LinearSolver::multigrid;
  study.revolution.n_lines = 512;
  study.revolution.meridian.n_harmonics = 32;
  const double weight = 0.3 * 9.81;
  study.revolution = study.revolution.resolved_for(weight);
  study.demand = { weight, 0, -values.number("moment") * weight * profile.contact_radius / 2 };
  study.demand.ring_radii = { 0.0295, 0.0305 };
  study.demand.n_harmonics = 4;
  return study;
}

/// Returns the goal a_2 / a_0 of the load summed over all rings, with a_0 = weight / (2 pi).
ContactGoal second_harmonic(const Case &study)
{
  const double mean = study.demand.normal_force / (2 * stemware::ring::pi);
  ContactGoal goal;
  goal.ring_radii = study.demand.ring_radii;
  goal.of_load = { { { 0, 0 }, { 0, 0 }, { 1 / mean, 1 / mean } }, Eigen::ArrayXXd::Zero(3, 2) };
  return goal;
}

/// Returns a_2 / a_0 of a body of revolution with elements of degree 4, half the usual cell size, and smaller
/// cells at re-entrant edges.
double truth(const Case &study)
{
  RevolutionSetup setup = study.revolution;
  setup.meridian.degree = 4;
  setup.resolution.refinements += 1;
  setup.corner_halvings += 12;
  return second_harmonic(study).of_load(MeshedRevolutionFoot(setup).solve(study.demand, study.slip).load);
}

/// Solves the contact on @p mesh and prints a row of the table. Returns the error estimate if @p estimates is
/// true, otherwise a default MeshError.
MeshError solve_on(const SolidMesh &mesh, const Case &study, double exact, const char *kind, bool estimates)
{
  const ContactGoal goal = second_harmonic(study);
  dealii::Timer timer;
  SolidFoot foot(mesh, study.solid);
  const ContactState state = foot.solve(study.demand, study.slip);
  const double value = goal.of_load(state.load), seconds = timer.wall_time();
  timer.restart();
  MeshError error;
  if (estimates)
    error = foot.mesh_error(state, goal, true).value(); // none if the contact is narrower than the cells
  say("{:8} {:9} {:+.9f} {:+.2e} {:+.2e} {:6.3f} {:7.1f} {:7.1f}\n", kind, foot.description().n_unknowns,
      value, exact - value, error.correction, error.correction / (exact - value), seconds, timer.wall_time());
  return error;
}

void run(const Case &study)
{
  const double exact = study.exact ? *study.exact : truth(study);
  say("body of revolution: a2/a0 = {:+.9f}\n", exact);
  say("mesh      unknowns      a2/a0     error   estimated  ratio  contact estimate (s)\n");
  FootResolution resolution = study.resolution;
  // On a hard table, an unrefined mesh has nodal multipliers, for which no error estimate exists. The first
  // mesh is therefore refined once.
  for (resolution.refinements = study.solid.table.interface->is_hard();
       resolution.refinements <= study.max_refinements; ++resolution.refinements)
    solve_on(generate_solid_mesh(study.solid.profile, resolution), study, exact, "uniform",
             resolution.refinements < std::min(2u, study.max_refinements));
  SolidMesh mesh = generate_solid_mesh(study.solid.profile, study.resolution);
  for (unsigned int n = 0; n < study.n_meshes; ++n)
  {
    if (mesh.triangulation->n_global_active_cells() * 24 > study.max_unknowns)
      break;
    const MeshError error = solve_on(mesh, study, exact, "adaptive", true);
    halve(mesh, error.mark(study.share));
  }
}

} // namespace

int main(int argc, char **argv)
{
  return run_benchmark(argc, argv, [&] { run(read_case(argc, argv)); });
}
