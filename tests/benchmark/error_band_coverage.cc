// Do the error bands that `stemware run` and `stemware converge` print hold? Random studies, each beside the
// same study four times finer. Build: cmake --preset bench && cmake --build --preset bench, run:
// build/bench/error_band_coverage [studies [seed [run]]]; with "run" the bands of `converge` are left out

#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/ranks.h"
#include "tests/benchmark/random_study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

using namespace stemware::pipeline;

/// Bands of one kind over all studies.
struct Tally
{
  unsigned int n_spins = 0;
  unsigned int n_spins_held = 0;
  unsigned int n_quantities = 0;
  unsigned int n_quantities_held = 0;
  std::vector<double> spin_excess; ///< band over true difference

  void add(const ErrorBands &bands, const std::vector<QuantityOfInterest> &finer)
  {
    for (std::size_t f = 0; f < finer.size(); ++f)
    {
      const BandedQuantity &banded = bands[f];
      const double difference = std::abs(banded.quantity.value - finer[f].value);
      const bool held = difference <= banded.band;
      ++n_quantities;
      n_quantities_held += held;
      if (!held)
        std::printf("      %s: %.9g, four times finer %.9g, band %.2g\n", banded.quantity.name.c_str(),
                    banded.quantity.value, finer[f].value, banded.band);
      if (banded.quantity.key != "omega_terminal")
        continue;
      ++n_spins;
      n_spins_held += held;
      spin_excess.push_back(banded.band / std::max(difference, banded.quantity.rounding));
      std::printf("      terminal spin %.9g, four times finer differs by %.2e, band %.2e, ratio %.1f%s\n",
                  banded.quantity.value, difference, banded.band, spin_excess.back(), held ? "" : " MISSED");
    }
  }

  void print(const char *name)
  {
    if (spin_excess.empty())
      return;
    std::sort(spin_excess.begin(), spin_excess.end());
    std::printf(
      "%s: %u of %u bands of the terminal spin hold, %u of %u of all quantities; band over true difference, "
      "terminal spin: median %.1f, least %.1f, greatest %.1f\n",
      name, n_spins_held, n_spins, n_quantities_held, n_quantities, spin_excess[spin_excess.size() / 2],
      spin_excess.front(), spin_excess.back());
  }
};

/// The bands of `converge` only where @p full is given.
void compare(const Study &study, Tally &quick, Tally *full)
{
  stemware::fem::ComplianceCache cache;
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, cache);
  const BalancedLoad load = find_load(study, foot);
  SpinQuestion question = { study.motion.orbit };
  question.with_slope = true;
  const SpinRow row = spin_row(load, question);
  const double omega = row.terminal->omega;
  const std::vector<double> spins = spins_of_interest(omega);
  const std::vector<QuantityOfInterest> own = quantities_of_load(study, load, spins, omega);
  const Study finer_study = four_times_finer(study);
  const std::vector<QuantityOfInterest> finer =
    quantities_of_load(finer_study, find_load(finer_study, study_foot(finer_study, cache)), spins, omega);
  std::printf("   run\n");
  quick.add(estimate_bands(study, foot, row, std::nullopt, cache), finer);
  std::fflush(stdout);
  if (full == nullptr)
    return;
  std::printf("   converge\n");
  full->add(refine(study, own, spins, refinement_axes(study, 3), cache).quantities, finer);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char *argv[])
{
  const MpiSession mpi;
  const int n_studies = argc > 1 ? std::atoi(argv[1]) : 20;
  RandomStudies studies(argc > 2 ? static_cast<unsigned int>(std::atoi(argv[2])) : 1);
  const bool with_converge = argc < 4 || std::string(argv[3]) != "run";
  Tally quick;
  Tally full;
  unsigned int n_failed = 0;
  for (int i = 0; i < n_studies; ++i)
  {
    const Study study = studies.next();
    std::printf("%2d %s, crown %.2g mm, %s\n", i + 1, table_name(study.table).c_str(),
                1000 * study.glass.profile.crown_radius, balance_name(study).c_str());
    try
    {
      compare(study, quick, with_converge ? &full : nullptr);
    }
    catch (const std::exception &failure)
    {
      ++n_failed;
      std::printf("   no solution: %s\n", failure.what());
    }
  }
  quick.print("run");
  full.print("converge");
  std::printf("%u studies without a solution\n", n_failed);
  return quick.n_spins_held == quick.n_spins && full.n_spins_held == full.n_spins ? 0 : 1;
}
