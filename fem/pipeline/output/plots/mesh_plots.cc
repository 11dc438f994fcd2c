#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/render/table_renderers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

Plot contact_zone_plot(const std::vector<fem::Quadrilateral> &faces)
{
  const std::string caption = "The faces of the contact zone, seen from above.";
  // One block of five corners a face, the first one again at the end.
  std::string data = "# " + caption + "\n# 1: x (mm)\n# 2: y (mm)\n";
  double reach = 1e-3; // of the square that is shown
  for (const fem::Quadrilateral &face : faces)
  {
    for (const auto &corner : face)
      reach = std::max({ reach, 1.05e3 * std::abs(corner[0]), 1.05e3 * std::abs(corner[1]) });
    for (std::size_t i = 0; i <= face.size(); ++i)
      data += fmt::format(FMT_STRING("{:.9g} {:.9g}\n"), 1000 * face[i % face.size()][0],
                          1000 * face[i % face.size()][1]);
    data += '\n';
  }
  return { "contact_zone",
           caption,
           fmt::format(FMT_STRING("set xrange [-{0:.5g}:{0:.5g}]; set yrange [-{0:.5g}:{0:.5g}]\n"), reach) +
             "set size ratio -1\nset xlabel \"x (mm)\"; set ylabel \"y (mm)\"\nunset key\n"
             "plot data with lines lt 1 lw 0.8\n",
           data,
           540,
           540 };
}

Plot quality_plot(const std::vector<double> &jacobians)
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
           "plot data using 1:2 with boxes lt 1\n",
           data_table(
             { caption, { numbers("middle of the bin", "1", bins), numbers("cells", "1", counts) } }),
           540,
           300 };
}

} // namespace stemware::pipeline
