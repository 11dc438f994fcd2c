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
    , modes(circles.n_harmonics(), n_lines)
{
  for (unsigned int n = 0; n <= circles.n_harmonics(); ++n)
    differences.push_back(difference(n, 0, n_radii()));
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

ForceModes ElasticResponse::force_modes(const Eigen::MatrixXd &forces) const
{
  ForceModes result;
  result.normal = modes.project(forces);
  if (has_sliding())
  {
    result.radial = modes.project(forces.cwiseProduct(slide_radial));
    result.azimuthal = modes.project_on_conjugates(forces.cwiseProduct(slide_azimuthal));
  }
  return result;
}

Eigen::MatrixXd ElasticResponse::displacement(const Eigen::MatrixXd &forces) const
{
  const CircleRange loaded(forces);
  const Eigen::MatrixXd normal = forces.middleRows(loaded.first, loaded.size);
  const double per_line = n_lines() / FourierBasis::norm(0);
  const auto columns = [&](const Eigen::MatrixXd &matrix)
  { return matrix.middleCols(loaded.first, loaded.size); };

  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_radii(), n_lines());
  add_product(columns(circles.tail.normal), per_line * normal, result);
  Eigen::MatrixXd radial_modes, azimuthal_modes;
  if (has_sliding())
  {
    const Eigen::MatrixXd radial = normal.cwiseProduct(slide_radial.middleRows(loaded.first, loaded.size));
    add_product(columns(circles.tail.radial), per_line * radial, result);
    radial_modes = modes.project(radial);
    azimuthal_modes =
      modes.project_on_conjugates(normal.cwiseProduct(slide_azimuthal.middleRows(loaded.first, loaded.size)));
  }
  const Eigen::MatrixXd normal_modes = modes.project(normal);
  Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Zero(n_radii(), modes.n_modes());
  for (unsigned int mode = 0; mode < modes.n_modes(); ++mode)
  {
    const HarmonicCompliance &harmonic = differences[FourierBasis::harmonic(mode)];
    add_product(columns(harmonic.normal), normal_modes.col(mode), amplitudes.col(mode));
    if (has_sliding())
    {
      add_product(columns(harmonic.radial), radial_modes.col(mode), amplitudes.col(mode));
      add_product(columns(harmonic.azimuthal), azimuthal_modes.col(mode), amplitudes.col(mode));
    }
    amplitudes.col(mode) /= FourierBasis::norm(mode);
  }
  return result + modes.evaluate(amplitudes);
}

HarmonicCompliance ElasticResponse::local(Eigen::Index first, Eigen::Index size) const
{
  const double per_line = n_lines() / FourierBasis::norm(0);
  HarmonicCompliance result;
  result.normal = per_line * circles.tail.normal.block(first, first, size, size);
  if (has_sliding())
    result.radial = per_line * circles.tail.radial.block(first, first, size, size);
  return result;
}

HarmonicCompliance ElasticResponse::difference(unsigned int harmonic, Eigen::Index first,
                                               Eigen::Index size) const
{
  const auto part = [&](const Eigen::MatrixXd &matrix) { return matrix.block(first, first, size, size); };
  const HarmonicCompliance &compliance = circles.harmonics[harmonic];
  return { part(compliance.normal) - part(circles.tail.normal),
           part(compliance.radial) - part(circles.tail.radial), part(compliance.azimuthal) };
}

} // namespace stemware::fem
