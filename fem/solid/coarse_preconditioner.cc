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
  int n_smoothing_steps = 4;   ///< degree of the Chebyshev polynomials between the finest and coarsest level
  double smoothing_range = 20; ///< largest eigenvalue over the lower end of the smoothed range
  int max_factorized_rows = 4000; ///< an aggregated level of more rows is aggregated further
  int max_sparse_rows = 10000;    ///< a matrix of more rows is aggregated; the next level has denser rows
};
constexpr AggregationParameters parameters = {};

} // namespace

std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG>
coarse_preconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix, std::vector<double> &modes)
{
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("prec type", "MGW"); // the finer the mesh, the more iterations a V-cycle takes
  list.set("PDE equations", 3);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", 6);
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: type (level 0)", "do-nothing"); // the caller smooths
  list.set("smoother: sweeps", parameters.n_smoothing_steps);
  list.set("smoother: Chebyshev alpha", parameters.smoothing_range);
  list.set("smoother: pre or post", "both");
  list.set("coarse: type", "Amesos-KLU");
  const bool is_small = matrix.m() <= static_cast<unsigned int>(parameters.max_sparse_rows);
  list.set("coarse: max size", is_small ? parameters.max_sparse_rows : parameters.max_factorized_rows);
  list.set("ML output", 0);
  auto result = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

} // namespace stemware::fem
