// Templates that libdeal.II instantiates for one SIMD lane only. They are in a separate file because two
// factory headers of deal.II 9.4.1 have the same include guard.
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>

namespace dealii::internal
{
template struct FEEvaluationFactory<3, VectorizedArray<double>>;
template struct FEEvaluationHangingNodesFactory<3, double, VectorizedArray<double>>;
template struct FEEvaluationHangingNodesFactory<3, float, VectorizedArray<float>>;
}
