#include "fem/pipeline/study/study_size.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/study/study_entries.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Unknowns per cell of linear elements: 1.5 nodes per cell in a generated mesh, which is a few cells thick.
constexpr double unknowns_per_cell = 4.5;

/// Adds the memory of a dense system (unknowns: harmonics times points across the land), of the state on all
/// lines, and of several factorised meridional problems.
void add_body_of_revolution(const ContactSection &contact, const fem::GlassProfile &profile,
                            const TableSection &table, StudySize &size)
{
  const double halvings = std::pow(2., contact.refinements);
  const double across = contact.degree * 2. * contact.resolution.radial_cells * halvings + 1;
  const auto slenderness = [](double length, double thickness) { return std::ceil(length / thickness); };
  double coarse =
    40 * contact.resolution.radial_cells + 4 * (slenderness(profile.foot_radius, profile.foot_thickness) +
                                                slenderness(profile.stem_height, profile.stem_radius));
  if (table.make().substrate)
    coarse += 4 * slenderness(table.disc.radius, table.disc.thickness);
  const double nodes = coarse * std::pow(halvings * contact.degree, 2);
  size.unknowns = across * (2. * contact.harmonics + 1);
  size.memory += 3 * 800 * nodes + 52 * size.unknowns * size.unknowns + 4000 * across * contact.azimuth_lines;
}

/// Returns the number of nodes in a mesh file, read from the section $Nodes or $ParametricNodes (in Gmsh's
/// format 4, the second number). For other files, the number is estimated from the file size.
double n_nodes(const std::string &file)
{
  constexpr double bytes_per_node = 80; // includes the bytes of the cells
  constexpr std::size_t head_size = 100000;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return 0;
  std::string head(head_size, '\0'); // limited, because a line may be as long as the file
  std::ifstream(file).read(head.data(), head_size);
  std::istringstream stream(head);
  std::string line;
  while (std::getline(stream, line))
    if ((line.rfind("$Nodes", 0) == 0 || line.rfind("$ParametricNodes", 0) == 0) &&
        std::getline(stream, line))
    {
      double first = 0, second = 0;
      std::istringstream numbers(line);
      return numbers >> first >> second ? second : first;
    }
  return static_cast<double>(std::filesystem::file_size(file, error)) / bytes_per_node;
}

void add_solid_body(const ContactSection &contact, unsigned int n_edge_halvings, StudySize &size)
{
  const double per_sector = (contact.resolution.radial_cells + 8.) * (contact.resolution.foot_layers + 0.);
  size.unknowns = contact.mesh_file.empty()
                    ? unknowns_per_cell * contact.resolution.azimuthal_cells * std::max(per_sector, 16.)
                    : 3 * n_nodes(contact.mesh_file);
  size.unknowns *= std::pow(8., contact.refinements);
  if (n_edge_halvings > 0) // the edge adds 19 to 28 cells per azimuthal cell, including transition cells
    size.unknowns +=
      unknowns_per_cell * 20 *
      std::ldexp(contact.resolution.azimuthal_cells, static_cast<int>(contact.refinements + n_edge_halvings));
  size.unknowns *= std::pow(contact.degree, 3);
  // Bytes per unknown (docs/method/solid_measurements.md).
  constexpr double factorised = 25e3;
  // If cells at the land's edge are halved, the coarser meshes of the hierarchy also have many cells, so
  // multigrid needs more memory.
  const double iterated = n_edge_halvings > 0 ? 1800 : 500;
  const bool is_factorised =
    contact.linear_solver == fem::LinearSolver::condensed ||
    (contact.linear_solver == fem::LinearSolver::automatic && contact.refinements == 0 &&
     n_edge_halvings == 0 && size.unknowns <= fem::max_condensed_unknowns);
  size.memory += size.unknowns * (is_factorised ? factorised : iterated);
}

StudyEntry costliest_entry(Study &study)
{
  const std::vector<StudyEntry> &standard = default_entries(), tried = study_entries(study);
  double least = size_of(study).memory;
  StudyEntry found = tried.front();
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (!tried[i].unit.empty() || tried[i].path_value != nullptr)
    {
      const std::string before = tried[i].text();
      tried[i].assign(standard[i].text());
      if (const double memory = size_of(study).memory; memory < least)
      {
        least = memory;
        found = tried[i];
      }
      tried[i].assign(before);
    }
  return found;
}

} // namespace

StudySize size_of(const Study &study)
{
  StudySize size;
  if (study.load.is_from_contact() && study.contact.is_of_revolution())
    add_body_of_revolution(study.contact, study.glass.profile, study.table, size);
  else if (study.load.is_from_contact())
    add_solid_body(study.contact, study.edge_halvings(), size);
  return size;
}

void require_affordable(const Study &study)
{
  // The adaptive method takes about ten steps per second of motion; forward Euler uses Motion/Euler step.
  constexpr double longest_step = 0.1;
  const double steps = study.motion.end_time / std::min(study.motion.euler_step, longest_step);
  if (steps > study.motion.step_limit)
    throw BadInput(fmt::format(
      FMT_STRING("Motion/End time = {} s in steps of Motion/Euler step = {} s takes about {:.2g} steps; use "
                 "longer steps or less time, or allow more with Motion/Step limit = {:.1e}."),
      to_short_text(study.motion.end_time), to_short_text(study.motion.euler_step), steps, 1.1 * steps));
  const StudySize size = size_of(study);
  if (size.memory > study.contact.memory_limit)
  {
    Study trial = study;
    const StudyEntry entry = costliest_entry(trial);
    const auto [needed, limit] = distinct_texts(size.memory / 1e9, study.contact.memory_limit / 1e9, 2);
    throw BadInput(
      fmt::format(FMT_STRING("{} = {} would take about {} GB of memory ({:.2g} unknowns), "
                             "above {} GB; give a {}, or allow more with Contact/Memory limit = {:.0f} GB."),
                  entry.path(), shortened_path(entry.text()), needed, size.unknowns, limit,
                  entry.path_value != nullptr ? "coarser mesh" : "value nearer to its default",
                  std::ceil(1.1 * size.memory / 1e9)));
  }
}

} // namespace stemware::pipeline
