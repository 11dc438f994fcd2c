// Cost of the solid body: matrix-free operators, a linear solve by geometric multigrid, a contact solution.
//
//   multigrid_benchmark [name=value]...
//
// cells=48,2,2 (around the rim, across the land, through the foot, of the coarsest mesh), refinements=2,
// land=0 (further halvings of the land), edge=0 (halvings of the land's inner side), degree=2, crown=0.003
// (0: a flat land of 2 mm), shape=step|foot, table=winkler|rough|spring (stiff spring for a hard table),
// modulus=1e11, moment=1.3, tolerance=1e-8 (of the linear solve), compare=no|yes (with the body of
// revolution).
#include "fem/contact/contact_load.h"
#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/mesh_hierarchy.h"
#include "fem/solid/nested_contact.h"
#include "fem/solid/simd/elastic_operator.h"
#include "tests/benchmark/solid_benchmark.h"

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>

using namespace stemware::fem;

namespace
{

struct Case
{
  GlassProfile profile;
  FootResolution resolution = { 48, 2, 2, 2 };
  SolidOptions options;
  std::shared_ptr<const InterfaceLaw> interface;
  double softening = 1; ///< on each coarser mesh, the interface is softer by this factor
  Resultants load;
  double tolerance = 1e-8; ///< of the timed linear solve
  bool compares = false;
};

Case read_case(int argc, char **argv)
{
  const NamedValues values(argc, argv,
                           { { "cells", "48,2,2" },
                             { "refinements", "2" },
                             { "land", "0" },
                             { "edge", "0" },
                             { "degree", "2" },
                             { "crown", "0.003" },
                             { "shape", "step" },
                             { "table", "winkler" },
                             { "modulus", "1e11" },
                             { "moment", "1.3" },
                             { "tolerance", "1e-8" },
                             { "compare", "no" } });
  Case study;
  const std::vector<unsigned int> cells = values.counts("cells");
  study.resolution = { cells.at(0),          cells.at(1),         cells.at(2), values.count("refinements"),
                       values.count("land"), values.count("edge") };
  study.profile = profile_of(values);
  study.options.degree = values.count("degree");
  study.options.linear_solver = LinearSolver::multigrid;
  if (values.text("table") == "spring")
  {
    study.interface = std::make_shared<WinklerInterface>(values.number("modulus"));
    study.softening = 8;
  }
  else if (values.text("table") == "rough")
    study.interface = std::make_shared<RoughInterface>(RoughInterface(1e6, 1e-6));
  else
    study.interface = std::make_shared<WinklerInterface>(values.number("modulus"));
  const double weight = 0.3 * 9.81;
  study.tolerance = values.number("tolerance");
  study.compares = values.text("compare") == "yes";
  study.load = { weight, 0, -values.number("moment") * weight * study.profile.contact_radius / 2 };
  return study;
}

/// Returns the maximum of |a_n - a_n'| / a_0 for n = 2 ... 8. The load a_n' is computed by a body of
/// revolution with a finer mesh, higher degree, and more harmonics and lines than usual.
double distance_from_revolution(const Case &study, const ContactLoad &load)
{
  RevolutionSetup setup;
  setup.profile = study.profile;
  setup.table.interface = study.softening == 1 ? study.interface : std::make_shared<HardInterface>();
  setup.meridian.degree = 3;
  setup.meridian.n_harmonics = 24;
  setup.resolution.refinements = 1;
  setup.n_lines = 512;
  ContactDemand demand = study.load;
  demand.n_harmonics = 8;
  const ContactLoad expected =
    MeshedRevolutionFoot(setup.resolved_for(study.load.normal_force)).solve(demand).load;
  double largest = 0;
  for (unsigned int n = 2; n <= 8; ++n)
    largest = std::max(largest, std::abs(load.a(n) - expected.a(n)) / expected.a(0));
  return largest;
}

template <typename Number>
double operator_seconds(const SolidLevel &level, const ElasticMaterial &glass)
{
  const auto stiffness =
    make_elastic_operator<Number>(level.mapping, level.dof_handler, level.constraints, glass);
  typename ElasticOperator<Number>::Vector from, to;
  stiffness->initialize_dof_vector(from);
  stiffness->initialize_dof_vector(to);
  from = 1;
  double fastest = 1e300;
  for (unsigned int i = 0; i < 5; ++i)
  {
    dealii::Timer timer;
    stiffness->vmult(to, from);
    fastest = std::min(fastest, timer.wall_time());
  }
  return fastest;
}

void run(const Case &study)
{
  const ElasticMaterial glass;
  const double radius = study.profile.contact_radius;
  dealii::Timer timer;
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  make_foot_mesh(study.profile, study.resolution, mesh);
  say("{} cells, {:.2f} s for the mesh\n", mesh.n_global_active_cells(), timer.wall_time());
  timer.restart();
  const auto gap = [&](double x, double y) { return study.profile.gap(std::hypot(x, y)); };
  SolidBody body(mesh, glass, gap, study.options);
  const double n = body.n_unknowns();
  say("{} unknowns, {} contact nodes, {} lanes, {:.2f} s for the set-up\n", body.n_unknowns(),
      body.contact_surface().n_global_nodes(), n_simd_lanes(), timer.wall_time());

  timer.restart();
  const std::optional<ContactStart> start =
    start_from_coarser_mesh(body, *study.interface, study.softening, study.load, radius);
  const double coarse_seconds = timer.wall_time();
  const auto law = study.interface->make(body.contact_surface(), 0);
  ContactControl control = study.softening == 1 ? ContactControl() : penalty_control();
  control.progress = [](const ContactIteration &step)
  {
    say("  step {}: {} loaded, {} changed, residual {:.1e}, length {:.2f}, {} iterations\n", step.number,
        step.n_loaded, step.n_changed, step.residual, step.step_length, step.linear_iterations);
  };
  const ContactSolution solution =
    solve_contact(body, *law, study.load, radius, control, start ? &*start : nullptr);
  const double contact_seconds = timer.wall_time();
  const ContactLoad load = extract_load(*law, solution, 8);
  say("a_n / a_0:");
  for (unsigned int h = 1; h <= 8; ++h)
    say(" {:.7f}", load.a(h) / load.a(0));
  say("\n{} steps, {} iterations, residuals {:.1e} {:.1e} {:.1e}\n", solution.n_iterations,
      solution.n_linear_iterations, solution.force_residual, solution.moment_residual,
      solution.equilibrium_residual);
  const double contact_peak = peak_bytes();

  ContactForces contact;
  law->evaluate(solution.normal_displacement, contact);
  body.reset();
  body.set_linear_tolerance(study.tolerance);
  timer.restart();
  const LinearConditions conditions = prescribed_resultants(body.contact_surface(), study.load);
  const NewtonIncrement linear = body.solve(contact.tangent, solution.forces, conditions, { 0, 0, 0 });
  const double linear_seconds = timer.wall_time();

  say("linear solve to {}: {} iterations, {:.2f} s, {:.3f} million unknowns/s\n", study.tolerance,
      linear.linear_iterations, linear_seconds, n / linear_seconds / 1e6);
  say("contact: {:.2f} s ({:.2f} s on coarser meshes), {:.2f} linear solves, {:.3f} million unknowns/s\n",
      contact_seconds, coarse_seconds, contact_seconds / linear_seconds, n / contact_seconds / 1e6);
  say("peak memory {:.2f} GB, {:.0f} bytes per unknown\n", contact_peak / 1e9, contact_peak / n);

  const auto alias = std::shared_ptr<const dealii::Triangulation<3>>(&mesh, [](const auto *) {});
  const SolidLevel level(alias, study.options.degree, study.options.degree);
  say("operator: {:.1f} million unknowns/s in double, ", n / operator_seconds<double>(level, glass) / 1e6);
  say("{:.1f} in float\n", n / operator_seconds<float>(level, glass) / 1e6);
  if (study.compares)
    say("largest difference to the body of revolution, n = 2 ... 8: {:.1e}\n",
        distance_from_revolution(study, load));
}

} // namespace

int main(int argc, char **argv)
{
  return run_benchmark(argc, argv, [&] { run(read_case(argc, argv)); });
}
