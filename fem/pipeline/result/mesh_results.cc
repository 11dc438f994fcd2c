#include "fem/pipeline/result/mesh_results.h"

#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"

#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

unsigned int n_faces(const fem::MeshCheck &check, fem::FootBoundary id)
{
  const auto found = check.n_faces.find(static_cast<unsigned int>(id));
  return found == check.n_faces.end() ? 0 : found->second;
}

/// Returns the number of faces with unused ids. These faces are treated as free.
unsigned int n_other_faces(const fem::MeshCheck &check)
{
  unsigned int n = 0;
  for (const auto &[id, count] : check.n_faces)
    n += id > static_cast<unsigned int>(fem::FootBoundary::contact_zone) ? count : 0;
  return n;
}

/// Returns warnings about properties of a mesh that may degrade results, one sentence each.
std::vector<std::string> mesh_remarks(const MeshFindings &findings)
{
  constexpr double poor = 0.1;
  const fem::MeshCheck &check = findings.check;
  std::vector<std::string> remarks;
  if (check.min_jacobian < poor)
    remarks.push_back("The worst cell's scaled Jacobian is " + to_short_text(check.min_jacobian) +
                      ", below 0.1: stresses near it are poor.");
  if (n_other_faces(check) > 0)
    remarks.push_back("Faces with ids other than 1 and 2 are taken as free.");
  if (check.outer_radius > 1)
    remarks.push_back("The contact zone has a radius of " + to_short_text(check.outer_radius) +
                      " m: is the mesh in metres?");
  return remarks;
}

/// Returns a range in mm, e.g. "x -34 to 34"; a single number if both ends are equal.
std::string mesh_range(const std::string &name, double least, double most)
{
  return fmt::format(FMT_STRING("{} {:.6g}"), name, 1e3 * least) +
         (least == most ? "" : fmt::format(FMT_STRING(" to {:.6g}"), 1e3 * most));
}

/// Returns a description of the rim, e.g. "round, middle radius 30 mm: the cells of the land follow the
/// circles".
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

} // namespace

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
  const auto &[x, y, z] = check.worst_place;
  std::vector<std::pair<std::string, std::string>> lines = {
    { "Mesh", fmt::format(FMT_STRING("{}, {} hexahedra, {} vertices"), findings.origin, check.n_cells,
                          check.n_vertices) },
    { "Box", mesh_range("x", check.lower[0], check.upper[0]) + ", " +
               mesh_range("y", check.lower[1], check.upper[1]) + ", " +
               mesh_range("z", check.lower[2], check.upper[2]) + " (mm)" },
    { "Faces", fmt::format(FMT_STRING("{} stem cut (id 1), {} contact zone (id 2), {} free, {} of other ids"),
                           n_faces(check, fem::FootBoundary::stem_cut),
                           n_faces(check, fem::FootBoundary::contact_zone),
                           n_faces(check, fem::FootBoundary::free), n_other_faces(check)) },
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

} // namespace stemware::pipeline
