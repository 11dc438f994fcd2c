#include "fem/line_pattern.h"

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

void LinePattern::add(std::size_t line, std::size_t image, const Eigen::Vector3d &sample_forces,
                      const Eigen::Matrix3d &sample_tangent, Eigen::VectorXd &forces,
                      Eigen::SparseMatrix<double> &tangent) const
{
  const ContactLine &contact_line = surface.lines[line];
  const Eigen::Matrix<double, 3, Eigen::Dynamic> &shape = contact_line.shape;
  const std::size_t n_nodes = contact_line.nodes.size();
  auto place = places[line].begin();
  auto image_place = places[image].begin();
  for (std::size_t i = 0; i < n_nodes; ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    const double force = shape.col(row).dot(sample_forces);
    forces(contact_line.nodes[i]) += force;
    if (image != line)
      forces(surface.lines[image].nodes[i]) += force;
    const Eigen::RowVector3d row_tangent = shape.col(row).transpose() * sample_tangent;
    for (std::size_t j = 0; j < n_nodes; ++j, ++place, ++image_place)
    {
      const double value = row_tangent.dot(shape.col(static_cast<Eigen::Index>(j)));
      tangent.valuePtr()[*place] += value;
      if (image != line)
        tangent.valuePtr()[*image_place] += value;
    }
  }
}

} // namespace stemware::fem
