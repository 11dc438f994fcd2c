#include "fem/solid/contact_nodes.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace stemware::fem
{

using namespace dealii;

namespace
{

class RankExchange : public SurfaceCommunicator
{
public:
  explicit RankExchange(const MPI_Comm &communicator)
      : communicator(communicator)
  {
  }

  void sum(double *values, std::size_t n) const override
  {
    const ArrayView<double> view(values, n);
    Utilities::MPI::sum(ArrayView<const double>(view), communicator, view);
  }

  double max(double value) const override { return Utilities::MPI::max(value, communicator); }

  std::vector<double> gather(const std::vector<double> &values, bool everywhere) const override
  {
    std::vector<double> gathered;
    for (const std::vector<double> &part : everywhere ? Utilities::MPI::all_gather(communicator, values)
                                                      : Utilities::MPI::gather(communicator, values))
      gathered.insert(gathered.end(), part.begin(), part.end());
    return gathered;
  }

private:
  const MPI_Comm communicator;
};

} // namespace

SurfaceParts parts_on_ranks(const MPI_Comm &communicator)
{
  return Utilities::MPI::n_mpi_processes(communicator) == 1
           ? SurfaceParts()
           : SurfaceParts(std::make_shared<RankExchange>(communicator));
}

ContactNodes::ContactNodes(const IndexSet &owned, std::vector<Dof> dofs, const MPI_Comm &communicator)
    : communicator(communicator)
    , all_parts(parts_on_ranks(communicator))
{
  IndexSet known(owned.size());
  known.add_indices(dofs.begin(), dofs.end());
  IndexSet others = known;
  others.subtract_set(owned);
  const Utilities::MPI::Partitioner among_dofs(owned, others, communicator);
  for (const auto &[begin, end] : among_dofs.import_indices())
    for (unsigned int place = begin; place < end; ++place)
      known.add_index(owned.nth_index_in_set(place));
  const IndexSet own = known & owned;
  all_dofs.assign(own.begin(), own.end());
  for (const Dof dof : all_dofs)
    places.push_back(static_cast<unsigned int>(owned.index_within_set(dof)));
  all_dofs.insert(all_dofs.end(), others.begin(), others.end());
  for (const auto &[rank, n] : among_dofs.ghost_targets())
    other_ranks.insert(other_ranks.end(), n, rank);

  // The node numbers are consecutive on each rank. Other ranks receive them as ghost values at the dofs.
  const Utilities::MPI::Partitioner among_nodes(Dof(places.size()), 0, communicator);
  const Dof first = among_nodes.local_range().first;
  LinearAlgebra::distributed::Vector<double> numbers(owned, others, communicator);
  for (std::size_t i = 0; i < places.size(); ++i)
    numbers.local_element(places[i]) = double(first + i);
  numbers.update_ghost_values();
  IndexSet other_numbers(among_nodes.size());
  for (const Dof dof : others)
    other_numbers.add_index(static_cast<Dof>(numbers(dof)));
  values.reinit(among_nodes.locally_owned_range(), other_numbers, communicator);
}

unsigned int ContactNodes::find(Dof dof) const
{
  const auto begin_of_others = all_dofs.begin() + n_owned_nodes();
  for (const auto &[begin, end] :
       { std::pair(all_dofs.begin(), begin_of_others), std::pair(begin_of_others, all_dofs.end()) })
  {
    const auto place = std::lower_bound(begin, end, dof);
    if (place != end && *place == dof)
      return static_cast<unsigned int>(place - all_dofs.begin());
  }
  return n_nodes();
}

Eigen::VectorXd ContactNodes::spread(const Eigen::VectorXd &own) const
{
  std::copy(own.begin(), own.end(), values.begin());
  values.update_ghost_values();
  Eigen::VectorXd result(n_nodes());
  for (unsigned int i = 0; i < n_nodes(); ++i)
    result(i) = values.local_element(i);
  values.zero_out_ghost_values();
  return result;
}

Eigen::VectorXd ContactNodes::summed(const Eigen::VectorXd &parts) const
{
  for (unsigned int i = 0; i < n_nodes(); ++i)
    values.local_element(i) = parts(i);
  values.compress(VectorOperation::add);
  return Eigen::Map<const Eigen::VectorXd>(values.begin(), n_owned_nodes());
}

double ContactNodes::norm(const Eigen::VectorXd &parts) const
{
  return std::sqrt(all_parts.sum(summed(parts).squaredNorm()));
}

std::vector<ContactNodes::Entry> ContactNodes::owned_rows(const Eigen::SparseMatrix<double> &parts) const
{
  // Dofs are sent as doubles, which represent integers below 2^53 exactly.
  using Packed = std::array<double, 3>;
  std::map<unsigned int, std::vector<Packed>> to_others;
  std::vector<Entry> rows;
  for (Eigen::Index column = 0; column < parts.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(parts, column); entry; ++entry)
    {
      const auto node = static_cast<unsigned int>(entry.row());
      const Dof row = all_dofs[node], of_column = all_dofs[static_cast<std::size_t>(column)];
      if (node < n_owned_nodes())
        rows.push_back({ row, of_column, entry.value() });
      else
        to_others[other_ranks[node - n_owned_nodes()]].push_back(
          { double(row), double(of_column), entry.value() });
    }
  for (const auto &received : Utilities::MPI::some_to_some(communicator, to_others))
    for (const Packed &entry : received.second)
      rows.push_back({ static_cast<Dof>(entry[0]), static_cast<Dof>(entry[1]), entry[2] });
  return rows;
}

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

void ContactStiffness::add_row_sums(LinearAlgebra::distributed::Vector<float> &diagonal) const
{
  if (!is_zero)
    contact_nodes->scatter_add(stiffness.cwiseAbs() * Eigen::VectorXd::Ones(stiffness.cols()), diagonal);
}

} // namespace stemware::fem
