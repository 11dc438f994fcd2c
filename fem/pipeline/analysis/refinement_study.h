#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/solve.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Kind of convergence along an axis, and the use of its band.
enum class AxisKind
{
  cells,  ///< algebraic, like size^p with halved sizes; the bands of these axes are added
  degree, ///< spectral; reduces the same errors as smaller cells: used if its band is wider
  azimuth ///< spectral: harmonics and azimuth lines; their bands are added
};

/// Values on successively finer levels, with observed order, limit and error.
struct RefinementSequence
{
  std::vector<double> values;
  std::optional<double> order; ///< observed order p of the last three values; std::nullopt if there is none
  double limit = 0;            ///< Richardson value if an order was observed, else the finest value
  std::vector<double> bands;   ///< half-widths: band of the finest value plus the distance from that value
  std::string key = {};        ///< key of the quantity
};

/// One numerical parameter of a study on successively finer levels, all others unchanged.
struct RefinementAxis
{
  std::string key;  ///< key in summary.json and converge.csv: "meridional_mesh"
  std::string name; ///< displayed name: "meridional mesh"
  std::string size; ///< unit of the sizes: "halvings of every cell"
  AxisKind kind = AxisKind::cells;
  std::vector<unsigned int> sizes = {}; ///< sizes of the levels, coarsest first
  std::vector<Variant> levels = {};
  std::size_t own = 0;                             ///< index of the study's own level
  std::vector<RefinementSequence> quantities = {}; ///< one per quantity, once the levels are solved
};

/// Returns all axes of @p study with up to @p n_levels levels each; the study's own level is the first if the
/// parameter cannot be reduced, else the second. Throws BadInput without a contact, with waviness, or with a
/// goal.
std::vector<RefinementAxis> refinement_axes(Study study, unsigned int n_levels);

/// Returns order, limit and bands of @p values, from the coarsest level to the finest
/// (docs/method/error_bands.md): grid convergence index, and Richardson's limit if cells show an order. @p
/// rounding: size of insignificant differences (solver tolerances). Throws std::invalid_argument unless there
/// are finite values.
RefinementSequence assess_convergence(const std::vector<double> &values, AxisKind kind, double rounding);

/// Solves @p axes around the study with the quantities @p own, quantities_of_load(), and returns the bands of
/// these quantities: the sum over the axes of cells (or the band of the degree, if it has finer
/// levels and is wider) plus the bands of harmonics and lines. Throws the exception of the first level that
/// fails, with the level's name.
ErrorBands refine(const std::vector<QuantityOfInterest> &own, std::vector<RefinementAxis> &axes,
                  const Executor &executor, Progress &progress = silent_progress());

} // namespace stemware::pipeline
