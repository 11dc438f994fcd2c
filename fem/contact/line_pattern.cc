#include "fem/contact/line_pattern.h"

#include <algorithm>

namespace stemware::fem
{

LinePattern::LinePattern(const ContactSurface &surface)
    : surface(surface)
    , empty(surface.n_nodes(), surface.n_nodes())
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const ContactLine &line : surface.lines)
    for (const unsigned int row : line.nodes)
      for (const unsigned int column : line.nodes)
        entries.emplace_back(row, column, 0.);
  empty.setFromTriplets(entries.begin(), entries.end());

  for (const ContactLine &line : surface.lines)
  {
    std::vector<int> &line_places = places.emplace_back();
    for (const unsigned int row : line.nodes)
      for (const unsigned int column : line.nodes)
      {
        const int *begin = empty.innerIndexPtr() + empty.outerIndexPtr()[column];
        const int *end = empty.innerIndexPtr() + empty.outerIndexPtr()[column + 1];
        const int *place = std::lower_bound(begin, end, static_cast<int>(row));
        line_places.push_back(static_cast<int>(place - empty.innerIndexPtr()));
      }
  }
}

void LinePattern::set_zero(Eigen::SparseMatrix<double> &tangent) const
{
  if (tangent.size() == 0)
    tangent = empty;
  else
    tangent.coeffs().setZero();
}

template <typename Forces, typename Tangent>
void LinePattern::add_at_nodes(std::size_t line, std::size_t image, const Forces &line_forces,
                               const Tangent &line_tangent, Eigen::VectorXd &forces,
                               Eigen::SparseMatrix<double> &tangent) const
{
  const std::vector<unsigned int> &nodes = surface.lines[line].nodes;
  const Eigen::Index n_nodes = line_forces.size();
  const int *place = places[line].data();
  for (Eigen::Index i = 0; i < n_nodes; ++i)
  {
    forces(nodes[static_cast<std::size_t>(i)]) += line_forces(i);
    for (Eigen::Index j = 0; j < n_nodes; ++j, ++place)
      tangent.valuePtr()[*place] += line_tangent(i, j);
  }
  if (image != line)
    add_at_nodes(image, image, line_forces, line_tangent, forces, tangent);
}

void LinePattern::add(std::size_t line, std::size_t image, const Eigen::Vector3d &sample_forces,
                      const Eigen::Matrix3d &sample_tangent, Eigen::VectorXd &forces,
                      Eigen::SparseMatrix<double> &tangent) const
{
  const ContactLine &contact_line = surface.lines[line];
  if (contact_line.samples_are_nodes)
    return add_at_nodes(line, image, sample_forces, sample_tangent, forces, tangent);
  constexpr int max_nodes = 25; // maximum number of nodes of a face; a fixed maximum avoids heap allocations
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_nodes, 1> node_forces =
    contact_line.shape.transpose() * sample_forces;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_nodes, max_nodes> node_tangent =
    contact_line.shape.transpose() * (sample_tangent * contact_line.shape);
  add_at_nodes(line, image, node_forces, node_tangent, forces, tangent);
}

} // namespace stemware::fem
