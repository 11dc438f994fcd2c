#pragma once

#include "fem/geometry/foot_resolution.h"
#include "fem/geometry/linear_solver.h"
#include "fem/geometry/mesh_report.h"
#include "fem/pipeline/study/entry_facts.h"

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

enum class BodyKind
{
  solid,     ///< three-dimensional finite elements, any mesh; all MPI ranks solve together
  revolution ///< displacement harmonics on a meridional mesh; rim and table may be wavy, the table elastic
};

enum class FrictionCoupling
{
  none,   ///< friction tractions do not change the pressure
  elastic ///< friction tractions deform foot and substrate
};

/// Returns the units of a mesh file's coordinates [m].
inline std::vector<std::pair<std::string, double>> mesh_units()
{
  return { { "m", 1 }, { "cm", 1e-2 }, { "mm", 1e-3 }, { "um", 1e-6 }, { "in", 0.0254 } };
}

/// Quantity for which a mesh is refined.
enum class Goal
{
  none,
  terminal_spin,
  a2,    ///< a_2 / a_0 at rest
  torque ///< tau_z at half the terminal spin
};

/// Maximum number of rings J. At x half-widths from the middle of the rings, Lagrange polynomials grow like
/// cosh(J acosh x) and amplify rounding: at x = 1.5 to 1e-6 of the load for J = 25, 1e-3 for 32, 1 for 40.
constexpr unsigned int max_rings = 25;

/// Subsection Contact: the elastic body and its discretisation.
struct ContactSection
{
  BodyKind body = BodyKind::revolution;
  std::string mesh_file; ///< empty: the mesh is generated from the glass
  fem::MeshFileOptions mesh_file_options;
  unsigned int degree = 2;
  fem::FootResolution resolution;
  fem::LinearSolver linear_solver = fem::LinearSolver::automatic;
  unsigned int refinements = 0; ///< halvings of every cell
  double land_grading = 3;      ///< size ratio of neighbouring cells across the land of a body of revolution
  unsigned int harmonics = 16;  ///< elastic harmonics of a body of revolution
  unsigned int azimuth_lines = 128; ///< lines on which a body of revolution integrates the table law
  unsigned int rings = 5;           ///< rings that represent the pressure
  /// Load harmonics of each ring; 0: as many as the lines resolve and the friction kernels need.
  unsigned int load_harmonics = 0;
  FrictionCoupling friction_coupling = FrictionCoupling::elastic;
  Goal goal = Goal::none;
  double goal_tolerance = 1e-5; ///< tolerance of the goal's estimated error, relative to the goal's value
  double memory_limit = 4e9;    ///< estimated memory above which a study is refused [byte]

  bool is_of_revolution() const { return body == BodyKind::revolution; }
  /// Returns the highest degree of the elements.
  unsigned int highest_degree() const { return is_of_revolution() ? 4 : 2; }

  /// Declares the entries with their facts. A template, to be compiled in one file only.
  template <typename List>
  void declare(List &list)
  {
    using fem::LinearSolver;
    const bool has_contact = list.study.load.is_from_contact();
    const bool has_mesh_file = has_contact && !mesh_file.empty();
    const bool is_generated = has_contact && mesh_file.empty();
    const bool is_revolved = has_contact && is_of_revolution();
    const bool is_crowned = is_revolved && list.study.glass.profile.crown_radius > 0;
    const bool is_solid = has_contact && !is_of_revolution();
    const bool is_generated_solid = is_solid && is_generated;
    list.enter("Contact", has_contact);
    list.choice("Body", body, { { "solid", BodyKind::solid }, { "revolution", BodyKind::revolution } },
                "revolution: displacement harmonics on a meridional mesh, for feet that are bodies of "
                "revolution: fast, and the way to elastic tables; solid: the foot in three-dimensional "
                "finite elements, for any mesh");
    list.path("Mesh file", mesh_file,
              "Mesh of the foot (.msh of Gmsh, hexahedra), which then also gives its shape; empty: "
              "generated from the subsection Glass. A relative path starts at the study file");
    list.choice("Mesh unit", mesh_file_options.unit, mesh_units(), "Unit of the coordinates in the mesh file",
                used_if(has_mesh_file));
    list.count("Mesh contact id", mesh_file_options.contact_id, 1, 65000,
               "Id of the faces of the mesh file that may touch the table", used_if(has_mesh_file));
    list.count("Mesh stem id", mesh_file_options.stem_id, 1, 65000,
               "Id of the faces of the mesh file where the stem was cut", used_if(has_mesh_file));
    list.number("Mesh contact height", mesh_file_options.contact_height, not_negative, "m",
                "All faces of the mesh file that look down and lie at most this high above its lowest point "
                "may touch the table, whatever their ids; 0: those of the id",
                used_if(has_mesh_file));
    list.count("Degree", degree, 1, 4,
               "Polynomial degree of the elements: 1 or 2 for a solid body, 1 to 4 for a body of revolution");
    list.count("Azimuthal cells", resolution.azimuthal_cells, 8, 2000,
               "Cells round the rim of the generated mesh of a solid body, a multiple of 4",
               used_if(is_generated_solid));
    list.count("Radial cells", resolution.radial_cells, 2, 200,
               "Cells across the land of a generated mesh, an even number", used_if(is_generated));
    list.count("Foot layers", resolution.foot_layers, 1, 100,
               "Cells through the thickness of the foot of the generated mesh of a solid body",
               used_if(is_generated_solid));
    list.count("Refinements", refinements, 0, 6,
               "Halvings of every cell of the mesh with these counts; the way to a large solid body, which "
               "is then solved by multigrid over the meshes between");
    list.number("Land grading", land_grading,
                { "a number from 1 to 10", [](double value) { return 1 <= value && value <= 10; } }, "1",
                "Size of a cell of the land over that of its neighbour nearer to the contact radius, for a "
                "crowned body of revolution; 1 means equal cells",
                used_if(is_crowned));
    list.choice(
      "Linear solver", linear_solver,
      { { "automatic", LinearSolver::automatic },
        { "condensed", LinearSolver::condensed },
        { "multigrid", LinearSolver::multigrid } },
      "automatic: condensed to the contact nodes for small systems on one rank, multigrid for others",
      used_if(is_solid));
    list.count("Harmonics", harmonics, 1, 1000,
               "Elastic harmonics of a body of revolution; without effect on a solid body",
               used_if(is_revolved));
    list.count("Azimuth lines", azimuth_lines, 16, 100000,
               "Azimuths at which a body of revolution meets the table, more than twice the harmonics; "
               "without effect on a solid body",
               used_if(is_revolved));
    list.count("Rings", rings, 1, max_rings,
               "Circles that take the pressure over, with all its radial moments below that number; 1: one "
               "ring of the radius that the moment asks for. More than 25 would magnify rounding");
    list.count("Load harmonics", load_harmonics, 0, 1000,
               "Harmonics of each ring's load; 0: as many as the lines resolve and the torque asks for");
    list.choice("Friction coupling", friction_coupling,
                { { "elastic", FrictionCoupling::elastic }, { "none", FrictionCoupling::none } },
                "elastic: the friction's tractions deform the foot and an elastic substrate; none: friction "
                "does not act back on the pressure");
    list.choice(
      "Goal", goal,
      { { "none", Goal::none },
        { "terminal spin", Goal::terminal_spin },
        { "a2", Goal::a2 },
        { "torque", Goal::torque } },
      "What the cells of a solid body that matter are halved for (torque: at half the terminal spin)",
      used_if(is_solid));
    list.number("Goal tolerance", goal_tolerance, positive, "1", "Error left of the goal, over its value",
                used_if(is_solid));
    list.number("Memory limit", memory_limit, positive, "B", "More is refused before the work");
  }
};

} // namespace stemware::pipeline
