#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

namespace stemware::pipeline
{

Plot convergence_plot(const std::string &name, const std::string &caption, const Axis &resolution,
                      const std::string &quantity, const std::vector<ConvergenceSeries> &series)
{
  const std::string data = "\"figures/" + name + ".dat\"";
  std::vector<Table> blocks;
  std::string drawings;
  for (std::size_t i = 0; i < series.size(); ++i)
  {
    blocks.push_back(
      { series[i].title,
        { numbers(resolution.label, "1", series[i].size), numbers(quantity, "1", series[i].error) } });
    const std::string block = data + " index " + std::to_string(i) + " using ";
    const std::string type = " lt " + std::to_string(i + 1) + " ";
    if (!series[i].band.empty())
    {
      blocks.back().columns.push_back(numbers("half-width of the error band", "1", series[i].band));
      drawings += block + "1:2:2:3 with yerrorbars" + type + "dt 1 lw 1 ps 0 notitle, \\\n     ";
    }
    drawings += block + "1:2 with linespoints" + type + "title " + gnuplot_text(series[i].title) +
                (i + 1 < series.size() ? ", \\\n     " : "\n");
  }
  std::string sizes;
  for (const ConvergenceSeries &item : series)
    for (const double size : item.size)
      sizes += (sizes.empty() ? "" : ", ") + to_text(size);
  const std::string script = axis_commands("x", resolution) + "set xtics (" + sizes + ") format \"%g\"\n" +
                             axis_commands("y", { quantity, true }) +
                             "set autoscale xfix; set offsets graph 0.05, graph 0.05\nplot " + drawings;
  return { name, caption, script, 540, 360, data_tables(blocks) };
}

} // namespace stemware::pipeline
