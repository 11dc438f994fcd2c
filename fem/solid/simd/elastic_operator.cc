// Instantiates deal.II's matrix-free evaluation for more SIMD lanes than Debian's library provides. See
// CMakeLists.txt.
#include "fem/solid/simd/elastic_operator.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/matrix_free/dof_info.templates.h>
#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/mapping_info_storage.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>
#include <deal.II/matrix_free/tools.h>

#include <stdexcept>
#include <string>

namespace stemware::fem
{

using namespace dealii;

namespace
{

template <unsigned int degree, typename Number>
class CellwiseOperator : public ElasticOperator<Number>
{
public:
  using typename ElasticOperator<Number>::Vector;

  CellwiseOperator(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                   const AffineConstraints<double> &constraints, const ElasticMaterial &material)
      : lambda(static_cast<Number>(material.lame_lambda()))
      , shear(static_cast<Number>(material.shear_modulus()))
  {
    typename Cells::AdditionalData data;
    data.tasks_parallel_scheme = Cells::AdditionalData::none;
    data.mapping_update_flags = update_gradients | update_JxW_values;
    cells.reinit(mapping, dof_handler, constraints, QGauss<1>(degree + 1), data);
  }

  void vmult(Vector &dst, const Vector &src) const override
  {
    cells.cell_loop(&CellwiseOperator::apply, this, dst, src, true);
    for (const unsigned int i : cells.get_constrained_dofs())
      dst.local_element(i) = src.local_element(i);
  }

  void compute_diagonal(Vector &diagonal) const override
  {
    cells.initialize_dof_vector(diagonal);
    const std::function<void(Evaluation &)> on_cell = [this](Evaluation &cell) { stress(cell); };
    MatrixFreeTools::compute_diagonal(cells, diagonal, on_cell);
    for (const unsigned int i : cells.get_constrained_dofs())
      diagonal.local_element(i) = 1;
  }

  void initialize_dof_vector(Vector &vector) const override { cells.initialize_dof_vector(vector); }

private:
  using Cells = MatrixFree<3, Number>;
  using Lanes = VectorizedArray<Number>;
  using Evaluation = FEEvaluation<3, static_cast<int>(degree), static_cast<int>(degree + 1), 3, Number>;

  /// Replaces nodal displacements by nodal forces in the cells of the SIMD batch @p cell.
  void stress(Evaluation &cell) const
  {
    cell.evaluate(EvaluationFlags::gradients);
    for (unsigned int q = 0; q < cell.n_q_points; ++q)
    {
      SymmetricTensor<2, 3, Lanes> tensor = cell.get_symmetric_gradient(q);
      const Lanes pressure = lambda * trace(tensor);
      tensor *= Lanes(2 * shear);
      for (unsigned int d = 0; d < 3; ++d)
        tensor[d][d] += pressure;
      cell.submit_symmetric_gradient(tensor, q);
    }
    cell.integrate(EvaluationFlags::gradients);
  }

  void apply(const Cells &, Vector &dst, const Vector &src,
             const std::pair<unsigned int, unsigned int> &range) const
  {
    Evaluation cell(cells);
    for (unsigned int batch = range.first; batch < range.second; ++batch)
    {
      cell.reinit(batch);
      cell.read_dof_values(src);
      stress(cell);
      cell.distribute_local_to_global(dst);
    }
  }

  const Number lambda;
  const Number shear;
  Cells cells;
};

} // namespace

template <typename Number>
std::unique_ptr<ElasticOperator<Number>>
make_elastic_operator(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                      const AffineConstraints<double> &constraints, const ElasticMaterial &material)
{
  const unsigned int degree = dof_handler.get_fe().degree;
  if (degree == 1)
    return std::make_unique<CellwiseOperator<1, Number>>(mapping, dof_handler, constraints, material);
  if (degree == 2)
    return std::make_unique<CellwiseOperator<2, Number>>(mapping, dof_handler, constraints, material);
  if (degree == 3)
    return std::make_unique<CellwiseOperator<3, Number>>(mapping, dof_handler, constraints, material);
  throw std::invalid_argument("Elements of degree " + std::to_string(degree) +
                              " have no matrix-free operator; take degree 1, 2 or 3.");
}

template std::unique_ptr<ElasticOperator<double>>
make_elastic_operator<double>(const Mapping<3> &, const DoFHandler<3> &, const AffineConstraints<double> &,
                              const ElasticMaterial &);
template std::unique_ptr<ElasticOperator<float>>
make_elastic_operator<float>(const Mapping<3> &, const DoFHandler<3> &, const AffineConstraints<double> &,
                             const ElasticMaterial &);

unsigned int n_simd_lanes()
{
  return VectorizedArray<double>::size();
}

} // namespace stemware::fem
