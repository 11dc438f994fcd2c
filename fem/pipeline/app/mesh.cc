#include "fem/pipeline/app/mesh.h"

#include "fem/geometry/mesh_writer.h"
#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/output/mesh_report.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/interruption.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text_file.h"

#include <deal.II/grid/tria.h>

#include <iostream>
#include <sstream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Triangulation = dealii::Triangulation<3, 3>;

namespace
{

/// What can be refused before any mesh is made.
void check_options(const MeshOptions &options)
{
  if (options.study.study_file.empty() && options.check.empty())
    throw BadInput("Say which mesh: a study file whose mesh is to be made, or --check with a mesh file.");
  if (options.study.study_file.empty() && !options.study.overrides.empty())
    throw BadInput("--set changes a study; name the study file, or leave --set away.");
  for (const std::string &file : options.writes)
  {
    const std::string extension = fs::path(file).extension();
    if (extension != ".msh" && extension != ".vtu")
      throw BadInput("--write " + file +
                     " ends in neither .msh nor .vtu; end it in the format that you want.");
    if (fs::exists(file) && !fs::is_regular_file(file))
      throw OutputFailure("--write " + file + " exists and is not a file; choose another name.");
  }
}

MeshFindings read_mesh(const std::string &file, const std::optional<Study> &study, Triangulation &mesh)
{
  MeshFindings findings;
  findings.origin = file;
  try
  {
    findings.report = fem::read_foot_mesh(file, mesh);
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
  findings.check = fem::check_mesh(mesh);
  if (study)
    require_same_glass(*findings.report, file, *study);
  return findings;
}

/// The study's generated foot as a file has to describe it, with the crown in the mesh.
MeshFindings generate_mesh(const Study &study, Triangulation &mesh)
{
  fem::make_foot_mesh(study.glass.profile, study.contact.resolution, mesh);
  fem::move_to_crown(study.glass.profile, mesh);
  return { "generated", fem::check_mesh(mesh), std::nullopt };
}

std::string as_text(const Triangulation &mesh, const std::string &format)
{
  std::ostringstream text;
  format == ".msh" ? fem::write_msh(mesh, text) : fem::write_mesh_vtu(mesh, text);
  return text.str();
}

void write_mesh(const Triangulation &mesh, const std::string &file)
{
  on_first_rank(
    [&]
    {
      replace_text_file(file, as_text(mesh, fs::path(file).extension()));
      return std::string();
    });
  console() << "Written   " << file << std::endl;
}

/// The findings on one line of standard output, for programs, where there is no folder of results.
void print_json(const Findings &findings)
{
  nlohmann::ordered_json line = { { "verb", "mesh" } };
  line.update(findings.key_figures);
  std::cout << line.dump() << std::endl;
}

} // namespace

void mesh(const MeshOptions &options)
{
  // 1. Which mesh, and where the results go.
  Stopwatch stopwatch;
  direct_console(options.study.quiet, options.study.json);
  check_options(options);
  std::optional<Study> study;
  if (!options.study.study_file.empty())
    study = read_study(options.study.study_file, options.study.overrides);
  const std::string file = options.check.empty() ? study->contact.mesh_file : options.check;
  watch_for_interruption();
  std::optional<SharedFolder> folder;
  if (!options.study.output.empty())
    folder.emplace(options.study.results_place());
  stopwatch.finish("input");

  // 2. What it is like, and whether it can be used.
  Triangulation mesh;
  const MeshFindings findings = file.empty() ? generate_mesh(*study, mesh) : read_mesh(file, study, mesh);
  console() << mesh_text(findings) << std::flush;
  require_usable(findings);
  stopwatch.finish("mesh");

  // 3. The mesh in files, and the report.
  for (const std::string &name : options.writes)
    write_mesh(mesh, name);
  Findings all = { { { "mesh", mesh_json(findings) } }, { { "written", options.writes } } };
  all.key_figures.update(mesh_json(findings));
  if (folder)
  {
    const Report report = mesh_report(findings, { fem::contact_faces(mesh), fem::scaled_jacobians(mesh) });
    folder->write([&](ResultsFolder &owned) { write_report(report, owned.working_folder()); });
    publish(options.study, study, all, *folder, stopwatch);
  }
  else if (options.study.json && is_first_rank())
    print_json(all);
}

} // namespace stemware::pipeline
