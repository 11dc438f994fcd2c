#include "fem/pipeline/report/gnuplot.h"

#include "fem/pipeline/support/child_process.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/shared_files.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

namespace stemware::pipeline
{

/// The files of plots/.
const CompiledTexts &compiled_plots();

namespace fs = std::filesystem;

namespace
{

constexpr std::array formats = { "svg", "pdf" };

fs::path plot_file(const Plot &plot, const std::string &extension)
{
  return fs::path("figures") / (plot.name + "." + extension);
}

std::string script_of(const Plot &plot)
{
  const std::string file = plot_file(plot, "gp").string();
  std::ostringstream script;
  script << "# " << boost::replace_all_copy(plot.caption, "\n", "\n# ")
         << "\n# Drawn again, as SVG or as PDF, in the folder of the results:\n"
         << "#   gnuplot " << file << "\n#   gnuplot -e 'format = \"pdf\"' " << file << "\n"
         << "name = \"" << plot.name << "\"; data = \"" << plot_file(plot, "dat").string()
         << "\"; width = 540; height = 360; note = \"\"\n"
         << plot.script << (plot.script.empty() || plot.script.back() != '\n' ? "\n" : "");
  return script.str();
}

void write_scripts(const std::vector<Plot> &plots, const fs::path &folder)
{
  fs::create_directory(folder / "figures"); // not the folder itself: an interruption may have taken it away
  write_text_file(folder / "figures/style.gnuplot", plot_file_text("style.gnuplot"));
  for (const Plot &plot : plots)
  {
    if (!plot.drawing.empty())
    {
      write_text_file(folder / plot_file(plot, "svg"), plot.drawing);
      continue;
    }
    write_text_file(folder / plot_file(plot, "gp"), script_of(plot));
    if (!plot.data.empty())
      write_text_file(folder / plot_file(plot, "dat"), plot.data);
  }
}

/// A gnuplot that draws some plots one after the other; a user's own start-up files have no say.
std::vector<std::string> drawing(const std::string &gnuplot, const std::string &format,
                                 const std::vector<Plot> &plots)
{
  std::vector<std::string> command = { gnuplot, "-d", "-e", "format = \"" + format + "\"" };
  for (const Plot &plot : plots)
    command.push_back(plot_file(plot, "gp").string());
  return command;
}

/// Draws one plot in one format, alone. Returns what gnuplot says when it fails; what it has drawn by then
/// is not kept.
std::string draw_alone(const std::string &gnuplot, const std::string &format, const Plot &plot,
                       const fs::path &folder)
{
  const EndedProgram ended = run_programs({ drawing(gnuplot, format, { plot }) }, folder).front();
  if (ended.exit_status == 0)
    return "";
  fs::remove(folder / plot_file(plot, format));
  return "gnuplot could not draw " + plot_file(plot, format).string() + " (" +
         (ended.messages.empty() ? "exit status " + std::to_string(ended.exit_status)
                                 : on_one_line(ended.messages)) +
         "). ";
}

/// The hour at which a PDF was made is the only thing in it that differs between equal runs: blanks instead.
void remove_date(const fs::path &pdf)
{
  std::fstream stream(pdf, std::ios::binary | std::ios::in | std::ios::out);
  std::ostringstream whole;
  whole << stream.rdbuf();
  const std::string text = whole.str();
  const auto begin = text.rfind("/CreationDate");
  const auto end = text.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos)
    return;
  stream.clear();
  stream.seekp(static_cast<std::streamoff>(begin));
  stream << std::string(end + 1 - begin, ' ');
}

} // namespace

std::string missing_plotter()
{
  if (find_program("gnuplot"))
    return "";
  return "gnuplot is not in the PATH: there will be no pictures, only their scripts and data; install it "
         "(Debian: apt-get install gnuplot-nox).";
}

std::string plot_file_text(const std::string &name)
{
  std::error_code error;
  for (const fs::path &shared : shared_folders())
    if (const fs::path file = shared / "plots" / name; fs::is_regular_file(file, error))
      return read_text_file(file);
  return text_of(compiled_plots(), name);
}

std::string draw_plots(const std::vector<Plot> &pictures, const fs::path &folder)
{
  write_scripts(pictures, folder);
  std::vector<Plot> plots;
  std::copy_if(pictures.begin(), pictures.end(), std::back_inserter(plots),
               [](const Plot &picture) { return picture.drawing.empty(); });
  const auto gnuplot = find_program("gnuplot");
  if (!gnuplot)
    return missing_plotter();
  if (plots.empty())
    return "";
  std::vector<std::vector<std::string>> commands;
  for (const char *format : formats)
    commands.push_back(drawing(gnuplot->string(), format, plots));
  const std::vector<EndedProgram> ended = run_programs(commands, folder);
  std::string trouble;
  for (std::size_t f = 0; f < formats.size(); ++f)
    if (ended[f].exit_status != 0)
      for (const Plot &plot : plots) // gnuplot stops at the first that fails
        trouble += draw_alone(gnuplot->string(), formats[f], plot, folder);
  for (const Plot &plot : plots)
    if (const fs::path pdf = folder / plot_file(plot, "pdf"); fs::exists(pdf))
      remove_date(pdf);
  return trouble;
}

} // namespace stemware::pipeline
