#pragma once

#include "fem/revolution/block_inverse.h"

#include <cholmod.h>

namespace stemware::fem
{

/// Factors L L' of symmetric positive definite matrices of equal pattern, by CHOLMOD. Functions throw
/// std::runtime_error if CHOLMOD fails, std::bad_alloc without memory.
class CholmodFactors
{
public:
  /// Prepares factors of matrices with the lower triangle @p pattern, eliminated in the order of its rows.
  explicit CholmodFactors(const LowerTriangle &pattern);
  CholmodFactors(const CholmodFactors &other);
  ~CholmodFactors();

  /// Returns whether factorise() proceeds by blocks, with BLAS.
  bool use_blas() const { return factor->is_super != 0; }
  void factorise(const LowerTriangle &matrix);
  /// Returns the last @p n rows and columns of L.
  Eigen::MatrixXd end(int n) const;

  /// Returns a minimum-degree order of elimination of @p pattern in which the rows @p last come last.
  static std::vector<int> order_with_last(const LowerTriangle &pattern,
                                          const std::vector<unsigned int> &last);

private:
  CholmodFactors();

  cholmod_common common;
  cholmod_factor *factor = nullptr;
};

} // namespace stemware::fem
