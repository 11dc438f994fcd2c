#include "fem/pipeline/report/mesh_results.h"

#include "fem/pipeline/report/document.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

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

/// "x -34 to 34", in mm; a single number where both are equal.
std::string mesh_range(const std::string &name, double least, double most)
{
  return fmt::format(FMT_STRING("{} {:.6g}"), name, 1e3 * least) +
         (least == most ? "" : fmt::format(FMT_STRING(" to {:.6g}"), 1e3 * most));
}

/// Description of a mesh, line by line: a word, and what there is to say.
nlohmann::ordered_json lines_of(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  using fem::FootBoundary;
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  const auto add = [&](const char *what, const std::string &is) {
    lines.push_back({ { "what", what }, { "is", is } });
  };
  add("Mesh", fmt::format(FMT_STRING("{}, {} hexahedra, {} vertices"), findings.origin, check.n_cells,
                          check.n_vertices));
  add("Box", mesh_range("x", check.lower[0], check.upper[0]) + ", " +
               mesh_range("y", check.lower[1], check.upper[1]) + ", " +
               mesh_range("z", check.lower[2], check.upper[2]) + " (mm)");
  add("Faces", fmt::format(FMT_STRING("{} stem cut (id 1), {} contact zone (id 2), {} free, {} of other ids"),
                           n_faces(check, FootBoundary::stem_cut), n_faces(check, FootBoundary::contact_zone),
                           n_faces(check, FootBoundary::free), n_other_faces(check)));
  add("Contact", mesh_range("r", check.inner_radius, check.outer_radius) + ", " +
                   mesh_range("z", check.lowest, check.highest) +
                   fmt::format(FMT_STRING(" (mm), area {:.6g} mm²"), 1e6 * check.contact_area));
  if (const auto &report = findings.report)
    add("Rim",
        fmt::format(FMT_STRING("{}round, middle radius {:.6g} mm: "), report->round_rim ? "" : "not ",
                    1e3 * report->rim_radius) +
          (report->round_rim ? "the cells of the land follow the circles"
                             : fmt::format(FMT_STRING("straight edges cut off about {:.2g} % of the land"),
                                           100 * report->land_area_deficit)));
  add("Quality",
      fmt::format(
        FMT_STRING("scaled Jacobian at least {:.3g}, near ({:.4g}, {:.4g}, {:.4g}) mm, {:.3g} on average"),
        check.least_jacobian, 1e3 * check.worst_place[0], 1e3 * check.worst_place[1],
        1e3 * check.worst_place[2], check.mean_jacobian));
  for (const std::string &remark : mesh_remarks(findings))
    add("Remark", remark);
  return lines;
}

nlohmann::ordered_json mesh_summary(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  nlohmann::ordered_json json = {
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

} // namespace

Results tabulate(const MeshFindings &findings, const MeshPictures &pictures,
                 const std::vector<std::string> &written)
{
  const fem::MeshCheck &check = findings.check;
  const nlohmann::ordered_json summary = mesh_summary(findings);
  Document document;
  document.findings.summary = { { "mesh", summary } };
  document.findings.key_figures = { { "written", written } };
  document.findings.key_figures.update(summary);
  document.facts = { { "inner_radius", check.inner_radius },
                     { "outer_radius", check.outer_radius },
                     { "has_section", !pictures.section.empty() } };
  if (!pictures.section.empty())
    add_section_plot(pictures.section, (check.inner_radius + check.outer_radius) / 2, 0, true, document);
  add_mesh_plots(pictures.contact_faces, pictures.scaled_jacobians, document);
  document.facts["lines"] = lines_of(findings);
  return shown(document, "mesh");
}

std::string mesh_text(const MeshFindings &findings)
{
  std::string text;
  for (const auto &line : lines_of(findings))
    text += wrapped(line["is"], fmt::format(FMT_STRING("{:<10}"), line["what"].get<std::string>())) + '\n';
  return text;
}

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

} // namespace stemware::pipeline
