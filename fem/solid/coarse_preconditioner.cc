#include "fem/solid/coarse_preconditioner.h"

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace stemware::fem
{

namespace
{

/// Parameters of ML, tuned on feet of 48 x 2 x 2 to 192 x 8 x 8 cells (docs/method/solid_measurements.md).
struct AggregationParameters
{
  int n_smoothing_steps = 4;      ///< degree of the Chebyshev smoother on the intermediate levels
  double smoothing_range = 20;    ///< largest eigenvalue divided by the lower end of the smoothed range
  int max_factorised_rows = 4000; ///< if an aggregated level has more rows, it is aggregated again
  /// If a matrix has more rows, it is aggregated, and the rows of the next level are denser.
  int max_sparse_rows = 10000;
};
constexpr AggregationParameters parameters = {};

} // namespace

std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG>
coarse_preconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix, std::vector<double> &modes)
{
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("prec type", "MGW"); // W-cycle, because the iterations of a V-cycle increase with mesh refinement
  list.set("PDE equations", 3);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", 6);
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: type (level 0)", "do-nothing"); // the caller smooths this level
  list.set("smoother: sweeps", parameters.n_smoothing_steps);
  list.set("smoother: Chebyshev alpha", parameters.smoothing_range);
  list.set("smoother: pre or post", "both");
  list.set("coarse: type", "Amesos-KLU");
  const bool is_small = matrix.m() <= static_cast<unsigned int>(parameters.max_sparse_rows);
  list.set("coarse: max size", is_small ? parameters.max_sparse_rows : parameters.max_factorised_rows);
  list.set("ML output", 0);
  auto result = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

} // namespace stemware::fem
