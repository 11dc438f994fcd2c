#include "fem/pipeline/report/render/report.h"

#include "fem/pipeline/report/gnuplot.h"
#include "fem/pipeline/report/render/html_page.h"
#include "fem/pipeline/support/text_file.h"

#include <iostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

void write_report(const Report &report, const fs::path &folder)
{
  std::vector<Plot> plots = report.pictures;
  for (const ReportSection &section : report.sections)
    plots.insert(plots.end(), section.plots.begin(), section.plots.end());
  const std::string notice = draw_plots(plots, folder);
  if (!notice.empty() && notice != missing_plotter())
    std::cerr << "stemware: " << notice << std::endl;

  std::map<std::string, std::string> pictures;
  for (const Plot &plot : plots)
  {
    const std::string svg = read_text_file(folder / "figures" / (plot.name + ".svg"));
    if (!svg.empty())
      pictures[plot.name] = svg;
  }
  write_text_file(folder / "report.html", html_page(report, pictures, notice));
}

} // namespace stemware::pipeline
