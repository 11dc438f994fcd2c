#include "fem/pipeline/app/mesh.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_mesh_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<MeshOptions>();
  CLI::App *verb = program.add_subcommand("mesh", "Write the three-dimensional mesh of a foot, or check one");
  verb->add_option("STUDY", options->study.study_file, "Study file, .prm or .json, whose mesh it is");
  verb->add_option("--check", options->check, "Looks at a mesh file instead")->type_name("FILE.msh");
  verb->add_option("--write", options->writes, "Writes the mesh; may be repeated")
    ->type_name("FILE.msh|FILE.vtu")
    ->allow_extra_args(false);
  verb
    ->add_option("--output", options->study.output, "Folder for report.html and summary.json; default: none")
    ->type_name("DIR");
  options->study.verb = "mesh";
  add_override_option(*verb, options->study);
  add_console_options(*verb, options->study);
  verb->footer(R"(Examples:
  stemware mesh my_glass.prm                                  what the study's mesh is like
  stemware mesh my_glass.prm --write foot.msh --write foot.vtu
  stemware mesh my_glass.prm --write fine.msh --set "Contact/Azimuthal cells=96"
  stemware mesh --check my_foot.msh                           can it be used? (exit code 1: no)
  stemware mesh my_glass.prm --check my_foot.msh              and is it of the same size?
  stemware mesh --check my_foot.msh --write my_foot.vtu       to look for the bad cells
  stemware mesh --check my_foot.msh --output results/my_foot  report.html with pictures

  .msh  Gmsh's format 2.2: linear hexahedra, stem cut with id 1, contact zone with id 2; can be
        read again with Contact/Mesh file. The crown is in it, as a polygon between vertices.
  .vtu  for ParaView: the cells with their scaled Jacobian and boundary id)");
  verb->callback([&chosen, options] { chosen = [options] { mesh(*options); }; });
}

} // namespace stemware::pipeline
