#include "fem/pipeline/report/mesh_results.h"

#include "fem/pipeline/report/document.h"
#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <sstream>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

unsigned int n_faces(const fem::MeshCheck &check, fem::FootBoundary id)
{
  const auto found = check.n_faces.find(static_cast<unsigned int>(id));
  return found == check.n_faces.end() ? 0 : found->second;
}

/// Faces with ids that mean nothing; they are as free as those without.
unsigned int n_other_faces(const fem::MeshCheck &check)
{
  unsigned int n = 0;
  for (const auto &[id, count] : check.n_faces)
    n += id > static_cast<unsigned int>(fem::FootBoundary::contact_zone) ? count : 0;
  return n;
}

/// Warnings of properties of a mesh that may make results worse, one sentence each.
std::vector<std::string> mesh_remarks(const MeshFindings &findings)
{
  constexpr double poor = 0.1;
  const fem::MeshCheck &check = findings.check;
  std::vector<std::string> remarks;
  if (check.least_jacobian < poor)
    remarks.push_back("The worst cell's scaled Jacobian is " + to_short_text(check.least_jacobian) +
                      ", below 0.1: stresses near it are poor.");
  if (n_other_faces(check) > 0)
    remarks.push_back("Faces with ids other than 1 and 2 are taken as free.");
  if (check.outer_radius > 1)
    remarks.push_back("The contact zone has a radius of " + to_short_text(check.outer_radius) +
                      " m: is the mesh in metres?");
  return remarks;
}

/// "x -34 to 34", in mm; a single number where both are equal.
std::string mesh_range(const std::string &name, double least, double most)
{
  return fmt::format(FMT_STRING("{} {:.6g}"), name, 1e3 * least) +
         (least == most ? "" : fmt::format(FMT_STRING(" to {:.6g}"), 1e3 * most));
}

Json mesh_summary(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  Json json = {
    { "mesh", findings.origin },
    { "cells", check.n_cells },
    { "vertices", check.n_vertices },
    { "faces",
      { { "stem_cut", n_faces(check, fem::FootBoundary::stem_cut) },
        { "contact_zone", n_faces(check, fem::FootBoundary::contact_zone) },
        { "free", n_faces(check, fem::FootBoundary::free) },
        { "other", n_other_faces(check) } } },
    { "box", { { "lower", check.lower }, { "upper", check.upper } } },
    { "contact_zone",
      { { "radii", { check.inner_radius, check.outer_radius } },
        { "heights", { check.lowest, check.highest } },
        { "centre", check.centre },
        { "area", check.contact_area } } },
    { "scaled_jacobian",
      { { "least", check.least_jacobian }, { "mean", check.mean_jacobian }, { "at", check.worst_place } } },
    { "remarks", mesh_remarks(findings) }
  };
  if (findings.report)
    json["rim"] = { { "round", findings.report->round_rim },
                    { "radius", findings.report->rim_radius },
                    { "land_area_deficit", findings.report->land_area_deficit } };
  return json;
}

/// The facts of the template mesh_lines, with the @p summary of the mesh.
Json facts_of(const fem::MeshCheck &check, const Json &summary)
{
  return {
    { "mesh", summary },
    { "rim", summary.value("rim", Json()) },
    { "cuts_land", summary.contains("rim") && summary["rim"]["land_area_deficit"] > 0 },
    { "inner_radius", check.inner_radius },
    { "outer_radius", check.outer_radius },
    { "box", mesh_range("x", check.lower[0], check.upper[0]) + ", " +
               mesh_range("y", check.lower[1], check.upper[1]) + ", " +
               mesh_range("z", check.lower[2], check.upper[2]) },
    { "radii", mesh_range("r", check.inner_radius, check.outer_radius) },
    { "heights", mesh_range("z", check.lowest, check.highest) },
    { "worst",
      { { "x", check.worst_place[0] }, { "y", check.worst_place[1] }, { "z", check.worst_place[2] } } }
  };
}

} // namespace

Results tabulate(const MeshFindings &findings, const MeshPictures &pictures,
                 const std::vector<std::string> &written)
{
  const fem::MeshCheck &check = findings.check;
  const Json summary = mesh_summary(findings);
  Document document;
  document.findings.summary = { { "mesh", summary } };
  document.findings.key_figures = { { "written", written } };
  document.findings.key_figures.update(summary);
  document.facts = facts_of(check, summary);
  document.facts["has_section"] = !pictures.section.empty();
  if (!pictures.section.empty())
    add_section_plot(pictures.section, (check.inner_radius + check.outer_radius) / 2, 0, true, document);
  add_mesh_plots(pictures.contact_faces, pictures.scaled_jacobians, document);
  return shown(document, "mesh");
}

std::string mesh_text(const MeshFindings &findings)
{
  const std::string row = "@row ", bar = " | ";
  std::istringstream lines(filled_text("mesh_lines.txt", facts_of(findings.check, mesh_summary(findings))));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (const auto end = line.find(bar); end != std::string::npos)
      text += wrapped(line.substr(end + bar.size()),
                      fmt::format(FMT_STRING("{:<10}"), line.substr(row.size(), end - row.size()))) +
              '\n';
  return text;
}

} // namespace stemware::pipeline
