#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/result/mesh_results.h"
#include "fem/pipeline/study/profile_file.h"
#include "fem/pipeline/study/study_file.h"

#include <deal.II/grid/tria.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <sstream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Mesh = dealii::Triangulation<3>;

namespace
{

struct MeshOptions
{
  StudyOptions study;
  std::string check;               ///< mesh file to check; empty: the study's own mesh
  std::vector<std::string> writes; ///< files to write, .msh or .vtu
};

/// Returns true if a study is needed: for its own mesh, or for the options and reference lengths of a mesh
/// file. Without file and study, the default study is used.
bool has_study(const MeshOptions &options)
{
  return !options.study.study_file.empty() || options.check.empty() || !options.study.overrides.empty();
}

/// Throws BadInput for options that are invalid for every mesh.
void check_options(const MeshOptions &options)
{
  for (const std::string &file : options.writes)
  {
    const std::string extension = fs::path(file).extension();
    if (extension != ".msh" && extension != ".vtu")
      throw BadInput("--write " + shortened_path(file) +
                     " ends in neither .msh nor .vtu; write a name with one of these endings.");
    on_first_rank([&] { require_writable(file); });
  }
}

MeshFindings read_mesh(const std::string &file, const ContactSection &contact, Mesh &mesh)
{
  const fem::MeshReport report = read_mesh_file(file, contact.mesh_file_options, mesh, contact.memory_limit);
  return { file, fem::check_mesh(mesh), report };
}

/// Generates the foot of @p study. The mesh includes the crown, as in a mesh file.
MeshFindings generate_mesh(const Study &study, Mesh &mesh)
{
  fem::make_foot_mesh(study.glass.profile, study.contact.resolution, mesh);
  fem::move_to_crown(study.glass.profile, mesh);
  return { "generated", fem::check_mesh(mesh), std::nullopt };
}

std::string as_text(const Mesh &mesh, const std::string &format)
{
  std::ostringstream text;
  format == ".msh" ? fem::write_msh(mesh, text) : fem::write_mesh_vtu(mesh, text);
  return text.str();
}

void write_mesh(const Mesh &mesh, const std::string &file)
{
  on_first_rank([&] { write_output_file(file, as_text(mesh, fs::path(file).extension())); });
  console() << "Written   " << file << std::endl;
}

/// Prints the findings as one line of JSON on standard output.
void print_json(const MeshFindings &findings, const MeshOptions &options)
{
  Json line = { { "verb", "mesh" }, { "written", options.writes } };
  line.update(mesh_summary(findings));
  std::cout << line.dump() << std::endl;
}

/// Checks the foot mesh of a study or a file, prints the findings and writes the mesh. Throws BadInput for an
/// unusable mesh, and OutputFailure.
void mesh(const MeshOptions &options)
{
  // 1. Input.
  direct_console(options.study.quiet, options.study.json);
  check_options(options);
  std::optional<Study> study;
  if (has_study(options))
    study = read_study(options.study.study_file, options.study.overrides);
  print_note("Profile   ", study ? profile_note(*study) : "");
  const std::string file = options.check.empty() ? study->contact.mesh_file : options.check;

  // 2. Findings, and checks of the mesh.
  Mesh mesh;
  const ContactSection contact = study ? study->contact : ContactSection();
  const MeshFindings findings = file.empty() ? generate_mesh(*study, mesh) : read_mesh(file, contact, mesh);
  console() << mesh_text(findings) << std::flush;
  require_usable(findings.origin, findings.check,
                 file.empty() ? fem::MeshFileOptions() : contact.mesh_file_options);
  const bool has_glass = study && (!options.study.study_file.empty() || options.check.empty() ||
                                   study->given_entries.count("Glass/Contact radius") > 0);
  if (has_glass && findings.report)
    require_same_glass(*findings.report, file, *study);

  // 3. Output files.
  for (const std::string &name : options.writes)
    write_mesh(mesh, name);
  if (options.study.json && is_first_rank())
    print_json(findings, options);
}

} // namespace

void add_mesh_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<MeshOptions>();
  CLI::App *verb =
    add_verb(program, chosen, "mesh", "Write the three-dimensional mesh of a foot, or check one",
             [options] { mesh(*options); });
  add_study_option(*verb, options->study, "whose mesh it is");
  verb->add_option("--check", options->check, "Checks a mesh file instead")->type_name("FILE.msh");
  verb->add_option("--write", options->writes, "Writes the mesh; may be repeated")
    ->type_name("FILE.msh|FILE.vtu")
    ->allow_extra_args(false);
  options->study.verb = "mesh";
  add_override_option(*verb, options->study);
  add_console_options(*verb, options->study);
}

} // namespace stemware::pipeline
