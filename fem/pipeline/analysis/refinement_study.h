#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/solve.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Kind of convergence along an axis.
enum class AxisKind
{
  cells,  ///< algebraic, like size^p with halved sizes; bands are added
  degree, ///< spectral; estimates the same error as `cells`, so the wider of the two bands is used
  azimuth ///< spectral, harmonics and azimuth lines; bands are added
};

/// Values on successively finer levels, with observed order, limit and error.
struct RefinementSequence
{
  std::vector<double> values;
  std::optional<double> order; ///< observed order p of the last three values, if any
  double limit = 0;            ///< Richardson value with an order, else the finest value
  std::vector<double> bands;   ///< half-widths: band of the finest value plus distance to it
  std::string key = {};        ///< key of the quantity
};

/// One numerical parameter of a study on successively finer levels.
struct RefinementAxis
{
  std::string key;  ///< key in summary.json and converge.csv: "meridional_mesh"
  std::string name; ///< displayed name: "meridional mesh"
  std::string size; ///< unit of the sizes: "halvings of every cell"
  AxisKind kind = AxisKind::cells;
  std::vector<unsigned int> sizes = {}; ///< coarsest first
  std::vector<Variant> levels = {};
  std::size_t own = 0;                             ///< index of the study's level
  std::vector<RefinementSequence> quantities = {}; ///< one per quantity, after refine()
};

/// Returns all axes of @p study with up to @p n_levels levels. The study's own level is the second; the first
/// if nothing coarser is allowed. Throws BadInput without a contact, with waviness, or with a goal.
std::vector<RefinementAxis> refinement_axes(Study study, unsigned int n_levels);

/// Returns order, limit and bands of @p values, from the coarsest to the finest level (grid convergence
/// index, docs/method/error_bands.md). @p rounding: size of insignificant differences (solver tolerances).
/// Throws std::invalid_argument without values or for values that are not finite.
RefinementSequence assess_convergence(const std::vector<double> &values, AxisKind kind, double rounding);

/// Solves the levels of @p axes and returns the bands of @p own, quantities_of_load() of the study. A band is
/// the sum of the bands of all axes of cells (or the band of the degree, if this is wider and the degree has
/// finer levels) and of the bands of harmonics and lines. Throws ring::NoBalance with the name of the first
/// level that fails.
ErrorBands refine(const std::vector<QuantityOfInterest> &own, std::vector<RefinementAxis> &axes,
                  const Executor &executor);

} // namespace stemware::pipeline
