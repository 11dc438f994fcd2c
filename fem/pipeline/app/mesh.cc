#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_file.h"

#include <deal.II/grid/tria.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

namespace stemware::pipeline
{

using Mesh = dealii::Triangulation<3>;

namespace fs = std::filesystem;

namespace
{

struct MeshFindings
{
  std::string origin; ///< mesh file, or "generated"
  fem::MeshCheck check;
  std::optional<fem::MeshReport> report; ///< std::nullopt for a generated mesh
};

/// Returns the numbers of faces by FootBoundary, and of faces with other boundary ids, which are treated as
/// free.
std::array<unsigned int, 4> n_faces(const fem::MeshCheck &check)
{
  std::array<unsigned int, 4> n = {};
  for (const auto &[id, count] : check.n_faces)
    n[std::min(id, 3u)] += count;
  return n;
}

std::vector<std::string> mesh_remarks(const MeshFindings &findings)
{
  constexpr double poor = 0.1;
  const fem::MeshCheck &check = findings.check;
  std::vector<std::string> remarks;
  if (check.min_jacobian < poor)
    remarks.push_back("The worst cell's scaled Jacobian is " + to_short_text(check.min_jacobian) +
                      ", below 0.1: stresses near it are poor.");
  if (n_faces(check).back() > 0)
    remarks.push_back("Faces with ids other than 1 and 2 are taken as free.");
  if (check.outer_radius > 1)
    remarks.push_back("The contact zone has a radius of " + to_short_text(check.outer_radius) +
                      " m: is the mesh in metres?");
  return remarks;
}

/// Returns a range in mm, e.g. "x -34 to 34".
std::string mesh_range(const std::string &name, double least, double most)
{
  return fmt::format(FMT_STRING("{} {:.6g}"), name, 1e3 * least) +
         (least == most ? "" : fmt::format(FMT_STRING(" to {:.6g}"), 1e3 * most));
}

std::string rim_text(const fem::MeshReport &report)
{
  return fmt::format(FMT_STRING("{}round, middle radius {:.6g} mm"), report.round_rim ? "" : "not ",
                     1e3 * report.rim_radius) +
         (report.round_rim ? ": the cells of the land follow the circles" : "") +
         (report.land_area_deficit > 0
            ? fmt::format(FMT_STRING(": straight edges cut off about {:.2g} % of the land"),
                          1e2 * report.land_area_deficit)
            : "");
}

/// Returns the description of a mesh as JSON, in SI units.
Json mesh_summary(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  const auto [free, stem_cut, contact_zone, other] = n_faces(check);
  Json json = {
    { "mesh", findings.origin },
    { "cells", check.n_cells },
    { "vertices", check.n_vertices },
    { "faces",
      { { "stem_cut", stem_cut }, { "contact_zone", contact_zone }, { "free", free }, { "other", other } } },
    { "box", { { "lower", check.lower }, { "upper", check.upper } } },
    { "contact_zone",
      { { "radii", { check.inner_radius, check.outer_radius } },
        { "heights", { check.lowest, check.highest } },
        { "centre", check.centre },
        { "area", check.contact_area } } },
    { "scaled_jacobian",
      { { "least", check.min_jacobian }, { "mean", check.mean_jacobian }, { "at", check.worst_place } } },
    { "remarks", mesh_remarks(findings) }
  };
  if (findings.report)
    json["rim"] = { { "round", findings.report->round_rim },
                    { "radius", findings.report->rim_radius },
                    { "land_area_deficit", findings.report->land_area_deficit } };
  return json;
}

std::string mesh_text(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  const auto [free, stem_cut, contact_zone, other] = n_faces(check);
  const auto &[x, y, z] = check.worst_place;
  std::vector<std::pair<std::string, std::string>> lines = {
    { "Mesh", fmt::format(FMT_STRING("{}, {} hexahedra, {} vertices"), findings.origin, check.n_cells,
                          check.n_vertices) },
    { "Box", mesh_range("x", check.lower[0], check.upper[0]) + ", " +
               mesh_range("y", check.lower[1], check.upper[1]) + ", " +
               mesh_range("z", check.lower[2], check.upper[2]) + " (mm)" },
    { "Faces", fmt::format(FMT_STRING("{} stem cut (id 1), {} contact zone (id 2), {} free, {} of other ids"),
                           stem_cut, contact_zone, free, other) },
    { "Contact", mesh_range("r", check.inner_radius, check.outer_radius) + ", " +
                   mesh_range("z", check.lowest, check.highest) +
                   fmt::format(FMT_STRING(" (mm), area {:.6g} mm²"), 1e6 * check.contact_area) }
  };
  if (findings.report)
    lines.emplace_back("Rim", rim_text(*findings.report));
  lines.emplace_back(
    "Quality",
    fmt::format(
      FMT_STRING("scaled Jacobian at least {:.3g}, near ({:.4g}, {:.4g}, {:.4g}) mm, {:.3g} on average"),
      check.min_jacobian, 1e3 * x, 1e3 * y, 1e3 * z, check.mean_jacobian));
  for (const std::string &remark : mesh_remarks(findings))
    lines.emplace_back("Remark", remark);
  std::string text;
  for (const auto &[label, line] : lines)
    text += wrapped(line, fmt::format(FMT_STRING("{:<10}"), label)) + '\n';
  return text;
}

struct MeshOptions
{
  StudyOptions study;
  std::string check;               ///< mesh file to check; empty: the study's own mesh
  std::vector<std::string> writes; ///< files to write, .msh or .vtu
};

void mesh(const MeshOptions &options)
{
  direct_console(options.study.quiet, options.study.json);
  for (const std::string &file : options.writes)
  {
    const std::string extension = fs::path(file).extension();
    if (extension != ".msh" && extension != ".vtu")
      throw BadInput("--write " + shortened_path(file) +
                     " ends in neither .msh nor .vtu; write a name with one of these endings.");
    on_first_rank([&] { require_writable(file); });
  }
  // The study defines the mesh, or the options and reference lengths of a mesh file.
  std::optional<Study> study;
  if (!options.study.study_file.empty() || options.check.empty() || !options.study.overrides.empty())
    study = read_study(options.study.study_file, options.study.overrides);
  print_note("Profile   ", study ? profile_note(study->glass) : "");
  const std::string file = options.check.empty() ? study->contact.mesh_file : options.check;

  Mesh mesh;
  const ContactSection contact = study ? study->contact : ContactSection();
  MeshFindings findings = { file, {}, std::nullopt };
  if (file.empty())
  {
    findings.origin = "generated";
    fem::make_foot_mesh(study->glass.profile, study->contact.resolution, mesh);
    fem::move_to_crown(study->glass.profile, mesh);
  }
  else
    findings.report = read_mesh_file(file, contact.mesh_file_options, mesh, contact.memory_limit);
  findings.check = fem::check_mesh(mesh);
  console() << mesh_text(findings) << std::flush;
  require_usable(findings.origin, findings.check,
                 file.empty() ? fem::MeshFileOptions() : contact.mesh_file_options);
  const bool has_glass = study && (!options.study.study_file.empty() || options.check.empty() ||
                                   study->given_entries.count("Glass/Contact radius") > 0);
  if (has_glass && findings.report)
    require_same_glass(*findings.report, file, study->contact.mesh_file_options.unit,
                       study->glass.profile.contact_radius);

  for (const std::string &name : options.writes)
  {
    on_first_rank(
      [&]
      {
        std::ostringstream text;
        fs::path(name).extension() == ".msh" ? fem::write_msh(mesh, text) : fem::write_mesh_vtu(mesh, text);
        write_output_file(name, text.str());
      });
    console() << "Written   " << name << std::endl;
  }
  if (options.study.json && is_first_rank())
  {
    Json line = { { "verb", "mesh" }, { "written", options.writes } };
    line.update(mesh_summary(findings));
    std::cout << line.dump() << std::endl;
  }
}

} // namespace

void add_mesh_verb(CLI::App &program)
{
  const auto options = std::make_shared<MeshOptions>();
  CLI::App *verb = add_verb(program, "mesh", "Write the three-dimensional mesh of a foot, or check one",
                            [options] { mesh(*options); });
  add_study_option(*verb, options->study, "whose mesh it is");
  verb->add_option("--check", options->check, "Checks a mesh file instead")->type_name("FILE.msh");
  verb->add_option("--write", options->writes, "Writes the mesh; may be repeated")
    ->type_name("FILE.msh|FILE.vtu")
    ->allow_extra_args(false);
  add_override_option(*verb, options->study);
  add_console_options(*verb, options->study);
}

} // namespace stemware::pipeline
