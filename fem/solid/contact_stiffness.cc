#include "fem/solid/contact_stiffness.h"

#include <utility>

namespace stemware::fem
{

using namespace dealii;

ContactStiffness::ContactStiffness(std::shared_ptr<const ContactNodes> nodes)
    : contact_nodes(std::move(nodes))
    , stiffness(contact_nodes->n_nodes(), contact_nodes->n_nodes())
{
}

void ContactStiffness::set(const Eigen::SparseMatrix<double> &tangent)
{
  stiffness = tangent;
  stiffness.prune(0., 0.);
  is_zero = !contact_nodes->parts().any(stiffness.nonZeros() > 0);
}

template <typename Number>
void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<Number> &dst,
                                 const LinearAlgebra::distributed::Vector<Number> &src) const
{
  if (!is_zero)
    contact_nodes->scatter_add(stiffness * contact_nodes->gather(src), dst);
}

void ContactStiffness::add_row_sums(LinearAlgebra::distributed::Vector<float> &diagonal) const
{
  if (!is_zero)
    contact_nodes->scatter_add(stiffness.cwiseAbs() * Eigen::VectorXd::Ones(stiffness.cols()), diagonal);
}

template void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<double> &,
                                          const LinearAlgebra::distributed::Vector<double> &) const;
template void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<float> &,
                                          const LinearAlgebra::distributed::Vector<float> &) const;

} // namespace stemware::fem
