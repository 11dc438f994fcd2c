#include "fem/revolution/line_tangents.h"

namespace stemware::fem
{

LineTangents::LineTangents(const Eigen::SparseMatrix<double> &tangent, unsigned int n_radii,
                           unsigned int n_lines, const std::vector<bool> &needed)
{
  // One row per coupled pair that occurs anywhere, found while reading; -1 where none has been seen.
  std::vector<int> row_of(n_radii * n_radii, -1);
  std::vector<std::pair<unsigned int, unsigned int>> found;
  Eigen::MatrixXd read = Eigen::MatrixXd::Zero(5 * n_radii, n_lines);
  std::vector<bool> is_loaded = needed;
  for (unsigned int line = 0; line < n_lines; ++line)
    for (unsigned int column = 0; column < n_radii; ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, line * n_radii + column); entry; ++entry)
      {
        const unsigned int row = static_cast<unsigned int>(entry.row()) - line * n_radii;
        if (row > column)
          break; // rows ascend
        if (entry.value() == 0)
          continue;
        int &index = row_of[row * n_radii + column];
        if (index < 0)
        {
          index = static_cast<int>(found.size());
          found.emplace_back(row, column);
          if (read.rows() < static_cast<Eigen::Index>(found.size()))
            read.conservativeResizeLike(Eigen::MatrixXd::Zero(2 * read.rows(), n_lines));
          is_loaded[row] = is_loaded[column] = true;
        }
        read(index, line) = entry.value();
      }

  std::vector<unsigned int> position(n_radii, 0);
  for (unsigned int i = 0; i < n_radii; ++i)
    if (is_loaded[i])
    {
      position[i] = static_cast<unsigned int>(circles.size());
      circles.push_back(i);
    }
  for (const auto &[row, column] : found)
    coupled_pairs.emplace_back(position[row], position[column]);
  values = read.topRows(static_cast<Eigen::Index>(found.size()));
}

bool LineTangents::is_even(double tolerance) const
{
  if (values.size() == 0)
    return true;
  const double allowed = tolerance * values.cwiseAbs().maxCoeff();
  const Eigen::Index n_lines = values.cols();
  for (Eigen::Index line = 1; 2 * line < n_lines; ++line)
    if ((values.col(line) - values.col(n_lines - line)).cwiseAbs().maxCoeff() > allowed)
      return false;
  return true;
}

} // namespace stemware::fem
