#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Convergence of a discretised quantity from level to level, and the effect of its band.
enum class AxisKind
{
  cells,  ///< like size^p, sizes halved from level to level: the bands of these axes are added
  degree, ///< spectrally; lessens the same errors as smaller cells: counts where its band is wider
  azimuth ///< spectrally: harmonics and azimuth lines, whose bands are added
};

/// Values on ever finer levels, with the observed order, the limit and the error.
struct RefinementSequence
{
  std::vector<double> values;
  std::optional<double> order; ///< observed p of the last three values; nothing where they do not show one
  double limit = 0;            ///< Richardson value where an order was observed, else the finest value
  std::vector<double> bands;   ///< half-widths: the finest value's, plus the distance from that value
};

/// One numerical parameter of a study on ever finer levels, all others as the study has them.
struct RefinementAxis
{
  std::string key;  ///< in summary.json and converge.csv: "meridional_mesh"
  std::string name; ///< for people: "meridional mesh"
  std::string size; ///< what the sizes count: "halvings of every cell"
  AxisKind kind = AxisKind::cells;
  std::vector<unsigned int> sizes = {}; ///< of the levels, coarsest first
  std::vector<Variant> levels = {};
  std::size_t own = 0;                             ///< the level that is the study itself
  std::vector<RefinementSequence> quantities = {}; ///< one per quantity, once the levels are solved
};

/// All axes of @p study with up to @p n_levels levels each: the study's own is the first where the parameter
/// cannot fall, else the second. Throws BadInput without a contact, with waviness, or with a goal.
std::vector<RefinementAxis> refinement_axes(Study study, unsigned int n_levels);

/// Judges @p values, from the coarsest level to the finest, as docs/method/error_bands.md says: grid
/// convergence index and Richardson's limit where cells show an order. @p rounding is the size of differences
/// that say nothing (solver tolerances). Throws std::invalid_argument unless there are finite values.
RefinementSequence assess_convergence(const std::vector<double> &values, AxisKind kind, double rounding);

/// Solves @p axes around the study whose own quantities are @p own, with the torque followed at @p spins, and
/// returns the bands of these quantities: the sum of the study's own bands over the axes of cells, or the
/// band of the degree where that has finer levels and is wider, plus those of harmonics and lines. Throws the
/// exception of the first level that fails, with the level named.
ErrorBands refine(const std::vector<QuantityOfInterest> &own, const std::vector<double> &spins,
                  std::vector<RefinementAxis> &axes, const Executor &executor,
                  Progress &progress = silent_progress());

} // namespace stemware::pipeline
