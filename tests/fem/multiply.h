#pragma once

#include <Epetra_Vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace stemware::fem_tests
{

/// Computes @p dst = @p matrix @p src. SparseMatrix::vmult() of deal.II's library, which g++ has compiled,
/// has a symbol that clang does not find.
template <typename Vector>
void multiply(const dealii::TrilinosWrappers::SparseMatrix &matrix, Vector &dst, const Vector &src)
{
  const Epetra_CrsMatrix &rows = matrix.trilinos_matrix();
  const Epetra_Vector from(View, rows.DomainMap(), const_cast<double *>(src.begin()));
  Epetra_Vector to(View, rows.RangeMap(), dst.begin());
  rows.Multiply(false, from, to);
}

} // namespace stemware::fem_tests
