// Checks the error bands of `stemware run` on random studies of seed SEED. Each study is compared with a
// finer reference, which does not use the refinement levels of the band: cells of 1/4 of the size in the
// contact and at corners, 4 times the azimuth lines and the elastic harmonics, 96 harmonics of the load, a
// penalty spring 100 times stiffer (hard interface), and sums over points instead of rings. With `converge`,
// the bands of `stemware converge` are checked, too. Wavy rims and tables are excluded. Build: cmake --preset
// bench && cmake --build --preset bench Run for the studies FIRST ... N:
//   build/bench/error_band_coverage [run|converge [N [SEED [FIRST]]]]
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/answer.h"
#include "tests/benchmark/random_study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace stemware;
using namespace stemware::pipeline;

std::vector<unsigned int> contact_cells(const std::vector<fem::SectionPolygon> &cells, const Study &study)
{
  const double height = 1e-6 * study.glass.profile.contact_radius;
  const double inner = study.glass.profile.land_inner_radius() - height,
               outer = study.glass.profile.land_outer_radius() + height;
  std::vector<unsigned int> found;
  for (unsigned int c = 0; c < cells.size(); ++c)
    if (std::count_if(cells[c].begin(), cells[c].end(),
                      [&](const auto &corner)
                      { return corner[1] < height && corner[0] > inner && corner[0] < outer; }) >= 2)
      found.push_back(c);
  return found;
}

/// Returns the indices of the cells at re-entrant corners (interior angle between 1.2 pi and 1.9 pi).
std::vector<unsigned int> corner_cells(const std::vector<fem::SectionPolygon> &cells)
{
  using Point = std::pair<long long, long long>; // in picometres
  const auto point = [](const std::array<double, 2> &at) -> Point {
    return { std::llround(at[0] * 1e12), std::llround(at[1] * 1e12) };
  };
  std::map<Point, double> angles;
  for (const fem::SectionPolygon &cell : cells)
    for (std::size_t v = 0; v < 4; ++v)
    {
      const auto &at = cell[v], &next = cell[(v + 1) % 4], &before = cell[(v + 3) % 4];
      const double x1 = next[0] - at[0], y1 = next[1] - at[1], x2 = before[0] - at[0], y2 = before[1] - at[1];
      angles[point(at)] += std::abs(std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
    }
  std::vector<unsigned int> found;
  for (unsigned int c = 0; c < cells.size(); ++c)
    for (const auto &corner : cells[c])
      if (const double angle = angles[point(corner)]; angle > 1.2 * ring::pi && angle < 1.9 * ring::pi)
      {
        found.push_back(c);
        break;
      }
  return found;
}

/// Study with refined cells: refinements in `study`, further halvings in `mesh`.
struct FineStudy
{
  Study study;
  Discretisation mesh = {};
};

/// Returns the study with all cells halved once. Cells in contact and at corners are halved @p n_halvings
/// times.
FineStudy with_smaller_cells(Study study, unsigned int n_halvings)
{
  study.contact.refinements += 1;
  Discretisation mesh;
  mesh.fineness *= std::ldexp(1, static_cast<int>(n_halvings) - 1);
  // The mesh of a flat land on a compliant interface is not graded towards the contact: `fineness` refines
  // all cells equally. The contact cells are therefore marked for further local refinement.
  const bool is_focused = study.glass.profile.crown_radius > 0 || study.table.is_hard();
  for (unsigned int i = 1; i < n_halvings; ++i)
  {
    const std::vector<fem::SectionPolygon> cells = foot_section({ study, mesh });
    std::vector<unsigned int> marked = corner_cells(cells);
    if (!is_focused)
      for (const unsigned int c : contact_cells(cells, study))
        marked.push_back(c);
    if (marked.empty())
      break;
    mesh.halved_cells.push_back(marked);
  }
  return { study, mesh };
}

FineStudy finer_in_everything(const Study &study)
{
  FineStudy finer = with_smaller_cells(study, 2);
  finer.study.contact.harmonics *= 4;
  finer.study.contact.azimuth_lines *= 4;
  finer.study.contact.load_harmonics = 96;
  if (study.table.is_hard())
    finer.mesh.hardness *= 100;
  return finer;
}

struct Solved
{
  std::shared_ptr<ElasticFoot> foot;
  BalancedLoad load;
  double omega = 0;
};

Solved solve(const FineStudy &fine, fem::ComplianceCache &cache, double expected = 0)
{
  const Study &study = fine.study;
  const std::shared_ptr<ElasticFoot> foot = study_foot({ study, fine.mesh }, foot_maker(cache));
  const BalancedLoad load = find_load(study, foot);
  const double omega = ring::answer(load, { study.motion.orbit, study.motion.grip_torque, {}, expected })
                         .value()
                         .omega_terminal()
                         .value();
  return { foot, load, omega };
}

/// Returns the friction torque [N m] about the axis at @p omega: the sum over @p points without projection
/// onto rings or harmonics.
double torque_of_points(const std::vector<fem::PointForce> &points, const ring::Motion &motion, double omega)
{
  double torque = 0;
  const double v = motion.orbit_speed;
  for (const fem::PointForce &point : points)
  {
    const double vx = v - omega * point.y, vy = omega * point.x;
    const double speed = std::hypot(vx, vy);
    torque -= motion.friction_at(speed) * point.force * (point.x * vy - point.y * vx) / speed;
  }
  return torque;
}

double change_by_points(const Study &study, const Solved &solved)
{
  const ring::Motion &motion = study.motion.orbit;
  const std::optional<fem::ContactState> state = solved.load.contact(solved.omega);
  if (!state)
    return 0;
  const double difference = torque_of_points(solved.foot->body().point_forces(*state), motion, solved.omega) -
                            ring::wrench(motion, state->load, solved.omega).torque;
  const double step = solved.load.spin_scale(motion) / 512;
  const double slope = (ring::yaw_torque(solved.load, motion, solved.omega + step) -
                        ring::yaw_torque(solved.load, motion, solved.omega - step)) /
                       (2 * step);
  return -difference / slope;
}

struct Tally
{
  unsigned int n_spins = 0;
  unsigned int n_held = 0;
  std::vector<double> excess; ///< ratios of error band to true error

  void add(const BandedQuantity &banded, double error)
  {
    const bool held = std::abs(error) <= banded.band;
    ++n_spins;
    n_held += held;
    excess.push_back(banded.band / std::max(std::abs(error), banded.quantity.rounding));
    std::printf("      terminal spin %.9g, true error %.2e, band %.2e, ratio %.1f%s\n", banded.quantity.value,
                error, banded.band, excess.back(), held ? "" : " MISSED");
  }

  void print(const char *name)
  {
    if (excess.empty())
      return;
    std::sort(excess.begin(), excess.end());
    std::printf(
      "%s: %u of %u bands of the terminal spin hold; band over true error: median %.1f, least %.1f, "
      "greatest %.1f\n",
      name, n_held, n_spins, excess[excess.size() / 2], excess.front(), excess.back());
  }
};

struct Tallies
{
  Tally run;
  Tally converge;
};

const BandedQuantity &spin_of(const ErrorBands &bands)
{
  for (const BandedQuantity &banded : bands)
    if (banded.quantity.key == "omega_terminal")
      return banded;
  throw std::runtime_error("no band");
}

void compare(const Study &study, bool with_converge, Tallies &tallies)
{
  fem::ComplianceCache cache;
  const Solved own = solve({ study }, cache);
  ring::Question question = { study.motion.orbit };
  question.grip_torque = study.motion.grip_torque;
  question.with_slope = true;
  const ring::Answer row = ring::answer(own.load, question).value();
  const ErrorBands bands = estimate_bands({ study, own.foot, ThreadedExecutor(cache) }, row, std::nullopt);
  const BandedQuantity &band = spin_of(bands);

  const FineStudy finer = finer_in_everything(study);
  const Solved solved = solve(finer, cache, own.omega);
  const double error = solved.omega + change_by_points(finer.study, solved) - own.omega;
  for (const auto &[part, value] : band.parts)
    std::printf("      %-15s %7.1e\n", part.c_str(), value);
  tallies.run.add(band, error);
  if (with_converge)
  {
    const std::vector<double> spins = spins_of_interest(own.omega);
    std::vector<RefinementAxis> axes = refinement_axes(study, 3);
    const ErrorBands wider =
      refine(quantities_of_load(study, own.load, spins, own.omega), axes, ThreadedExecutor(cache));
    tallies.converge.add(spin_of(wider), error);
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char *argv[])
{
  const MpiSession mpi;
  const std::string bands = argc > 1 ? argv[1] : "run";
  const int n_studies = argc > 2 ? std::atoi(argv[2]) : 20;
  RandomStudies studies(argc > 3 ? static_cast<unsigned int>(std::atoi(argv[3])) : 1);
  const int first = argc > 4 ? std::atoi(argv[4]) : 1;
  if (bands != "run" && bands != "converge")
  {
    std::fprintf(stderr, "error_band_coverage does not know %s.\n", bands.c_str());
    return 1;
  }
  Tallies tallies;
  unsigned int n_failed = 0;
  for (int i = 1; i <= n_studies; ++i)
  {
    Study study = studies.next();
    while (study.has_waviness())
      study = studies.next();
    if (i < first)
      continue;
    std::printf("%2d %s, crown %.2g mm, %s\n", i, table_name(study.table).c_str(),
                1000 * study.glass.profile.crown_radius, balance_name(study).c_str());
    std::fflush(stdout);
    try
    {
      compare(study, bands == "converge", tallies);
    }
    catch (const std::exception &failure)
    {
      ++n_failed;
      std::printf("   no solution: %s\n", failure.what());
    }
  }
  tallies.run.print("run");
  tallies.converge.print("converge");
  std::printf("%u studies without a solution\n", n_failed);
  return tallies.run.n_held == tallies.run.n_spins ? 0 : 1;
}
