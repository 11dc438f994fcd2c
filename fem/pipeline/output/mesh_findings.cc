#include "fem/pipeline/output/mesh_findings.h"

#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_layout.h"

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

std::string rim_text(const fem::MeshReport &report)
{
  return report.round_rim
           ? formatted("round, middle radius %.6g m: the cells of the land follow the circles",
                       report.rim_radius)
           : formatted("not round, middle radius %.6g m: straight edges cut off about %.2g %% of the land",
                       report.rim_radius, 100 * report.land_area_deficit);
}

} // namespace

std::string mesh_text(const MeshFindings &findings)
{
  const fem::MeshCheck &check = findings.check;
  std::string text = "Mesh      " + findings.origin +
                     formatted(", %u hexahedra, %u vertices\n", check.n_cells, check.n_vertices);
  text += formatted("Box       x %.6g to %.6g, y %.6g to %.6g, z %.6g to %.6g (m)\n", check.lower[0],
                    check.upper[0], check.lower[1], check.upper[1], check.lower[2], check.upper[2]);
  text +=
    formatted("Faces     %u stem cut (id 1), %u contact zone (id 2), %u free, %u of other ids\n",
              n_faces(check, fem::FootBoundary::stem_cut), n_faces(check, fem::FootBoundary::contact_zone),
              n_faces(check, fem::FootBoundary::free), n_other_faces(check));
  text += formatted("Contact   r %.6g to %.6g, z %.6g to %.6g (m), area %.6g m^2\n", check.inner_radius,
                    check.outer_radius, check.lowest, check.highest, check.contact_area);
  if (findings.report)
    text += "Rim       " + rim_text(*findings.report) + '\n';
  text += formatted("Quality   scaled Jacobian at least %.3g, near (%.4g, %.4g, %.4g), %.3g on average\n",
                    check.least_jacobian, check.worst_place[0], check.worst_place[1], check.worst_place[2],
                    check.mean_jacobian);
  for (const std::string &remark : mesh_remarks(findings))
    text += wrapped(remark, "Remark    ") + '\n';
  return text;
}

nlohmann::ordered_json mesh_json(const MeshFindings &findings)
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
