#include "fem/pipeline/output/mesh_report.h"

#include "fem/pipeline/output/render/plots.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// One block of five corners a face, the first one again at the end.
ReportFigure contact_zone_figure(const std::vector<fem::Quadrilateral> &faces)
{
  const std::string caption = "The faces of the contact zone, seen from above.";
  std::ostringstream data;
  data.precision(9);
  data << "# " << caption << "\n# 1: x (mm)\n# 2: y (mm)\n";
  for (const fem::Quadrilateral &face : faces)
  {
    for (std::size_t i = 0; i <= face.size(); ++i)
      data << 1000 * face[i % face.size()][0] << ' ' << 1000 * face[i % face.size()][1] << '\n';
    data << '\n';
  }
  return { "contact_zone",
           caption,
           "set size ratio -1\nset xlabel \"x (mm)\"; set ylabel \"y (mm)\"\nunset key\n"
           "plot \"figures/contact_zone.dat\" with lines lt 1 lw 0.8\n",
           540,
           540,
           data.str() };
}

ReportFigure quality_figure(const std::vector<double> &jacobians)
{
  constexpr unsigned int n_bins = 20;
  std::vector<double> bins, counts(n_bins, 0);
  for (unsigned int b = 0; b < n_bins; ++b)
    bins.push_back((b + 0.5) / n_bins);
  for (const double jacobian : jacobians)
  {
    const int bin = static_cast<int>(jacobian * n_bins);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, static_cast<int>(n_bins) - 1))];
  }
  const std::string caption =
    "Scaled Jacobians of the cells: 1 is a brick, below 0.1 stresses nearby are poor.";
  return { "quality",
           caption,
           "set xlabel \"scaled Jacobian\"; set ylabel \"cells\"\nset xrange [0:1]; set yrange [0:*]\n"
           "unset key\nset boxwidth 0.9 relative; set style fill solid noborder\n"
           "plot \"figures/quality.dat\" using 1:2 with boxes lt 1\n",
           540,
           300,
           data_table(caption, { { "middle of the bin", "1", bins }, { "cells", "1", counts } }) };
}

/// The lines of mesh_text(), each a name and a description.
ReportTable findings_table(const MeshFindings &findings)
{
  ReportTable table = { "", { "", "" }, {} };
  std::istringstream lines(mesh_text(findings));
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t end = line.find(' ');
    table.rows.push_back({ line.substr(0, end), line.substr(line.find_first_not_of(' ', end)) });
  }
  return table;
}

} // namespace

Report mesh_report(const MeshFindings &findings, const MeshPictures &pictures)
{
  const fem::MeshCheck &check = findings.check;
  Report report;
  report.title = "Mesh of a foot";
  report.answer =
    formatted("The mesh can be used: %u hexahedra whose scaled Jacobian is %.3g at least, a contact zone "
              "of %.4g mm² between radii of %.4g and %.4g mm.",
              check.n_cells, check.least_jacobian, 1e6 * check.contact_area, 1e3 * check.inner_radius,
              1e3 * check.outer_radius);
  for (const std::string &remark : mesh_remarks(findings))
    report.answer += " " + remark;
  report.sections.push_back(
    { "What it is like",
      "",
      { contact_zone_figure(pictures.contact_faces), quality_figure(pictures.scaled_jacobians) },
      { findings_table(findings) } });
  report.sections.push_back({ "Files", "", {}, {}, { { "summary.json", "the same for programs" } } });
  return report;
}

} // namespace stemware::pipeline
