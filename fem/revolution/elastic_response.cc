#include "fem/revolution/elastic_response.h"

#include "fem/revolution/dense_algebra.h"

#include <utility>

namespace stemware::fem
{

namespace
{

struct CircleRange
{
  explicit CircleRange(const Eigen::MatrixXd &forces)
  {
    Eigen::Index last = forces.rows() - 1;
    while (first < last && (forces.row(first).array() == 0).all())
      ++first;
    while (last > first && (forces.row(last).array() == 0).all())
      --last;
    size = last - first + 1;
  }
  Eigen::Index first = 0;
  Eigen::Index size = 0;
};

} // namespace

ElasticResponse::ElasticResponse(ContactCompliance compliance, unsigned int n_lines)
    : circles(std::move(compliance))
    , differences(circles.harmonics)
    , modes(circles.n_harmonics(), n_lines)
{
  for (HarmonicCompliance &harmonic : differences)
  {
    harmonic.normal -= circles.tail.normal;
    harmonic.radial -= circles.tail.radial;
  }
}

void ElasticResponse::set_sliding(const std::optional<SlidingTraction> &traction)
{
  if (!traction || traction->friction_coefficient == 0)
  {
    slide_radial.resize(0, 0);
    slide_azimuthal.resize(0, 0);
    return;
  }
  traction->validate();
  slide_radial.resize(n_radii(), n_lines());
  slide_azimuthal.resize(n_radii(), n_lines());
  for (unsigned int j = 0; j < n_lines(); ++j)
    for (unsigned int i = 0; i < n_radii(); ++i)
    {
      const Eigen::Vector2d direction = traction->direction(circles.radii(i), modes.azimuth(j));
      slide_radial(i, j) = direction(0);
      slide_azimuthal(i, j) = direction(1);
    }
}

ForceModes ElasticResponse::force_modes(const Eigen::MatrixXd &forces, Eigen::Index first) const
{
  const auto times = [&](const Eigen::MatrixXd &traction) -> Eigen::MatrixXd
  { return forces.cwiseProduct(traction.middleRows(first, forces.rows())); };
  ForceModes result;
  result.normal = modes.project(forces);
  if (has_sliding())
  {
    result.radial = modes.project(times(slide_radial));
    result.azimuthal = modes.project_on_conjugates(times(slide_azimuthal));
  }
  return result;
}

Eigen::MatrixXd ElasticResponse::displacement(const Eigen::MatrixXd &forces) const
{
  const CircleRange loaded(forces);
  const Eigen::MatrixXd normal = forces.middleRows(loaded.first, loaded.size);
  const auto columns = [&](const Eigen::MatrixXd &matrix)
  { return matrix.middleCols(loaded.first, loaded.size); };

  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_radii(), n_lines());
  add_product(columns(circles.tail.normal), lines_per_radian() * normal, result);
  if (has_sliding())
    add_product(columns(circles.tail.radial),
                lines_per_radian() * normal.cwiseProduct(slide_radial.middleRows(loaded.first, loaded.size)),
                result);
  const ForceModes of_forces = force_modes(normal, loaded.first);
  Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Zero(n_radii(), modes.n_modes());
  for (unsigned int mode = 0; mode < modes.n_modes(); ++mode)
  {
    const HarmonicCompliance &harmonic = differences[FourierBasis::harmonic(mode)];
    add_product(columns(harmonic.normal), of_forces.normal.col(mode), amplitudes.col(mode));
    if (has_sliding())
    {
      add_product(columns(harmonic.radial), of_forces.radial.col(mode), amplitudes.col(mode));
      add_product(columns(harmonic.azimuthal), of_forces.azimuthal.col(mode), amplitudes.col(mode));
    }
    amplitudes.col(mode) /= FourierBasis::norm(mode);
  }
  return result + modes.evaluate(amplitudes);
}

} // namespace stemware::fem
