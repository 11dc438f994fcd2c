#include "fem/pipeline/coupling/leaning_load.h"

namespace stemware::pipeline
{

std::vector<double> LeaningLoad::coefficients(unsigned int n_harmonics) const
{
  std::vector<double> row = rings.coefficients(n_harmonics);
  row.insert(row.end(), { tilt.x(), tilt.y() });
  return row;
}

LeaningLoad LeaningLoad::from_coefficients(std::vector<double> row, std::size_t n_rings)
{
  const Eigen::Vector2d tilt(row[row.size() - 2], row[row.size() - 1]);
  row.resize(row.size() - 2);
  return { ring::RingStack::from_coefficients(row, n_rings), tilt };
}

} // namespace stemware::pipeline
