#include "fem/pipeline/coupling/phase_samples.h"

#include "ring_model/friction_functionals.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

ring::Orientation PhaseGrids::phase(unsigned int i) const
{
  return { glass.node(node(&PhaseGrids::glass, i)), table.node(node(&PhaseGrids::table, i)) };
}

unsigned int PhaseGrids::node(Angle angle, unsigned int i) const
{
  return angle == &PhaseGrids::glass ? i / table.size() : i % table.size();
}

PhaseGrids PhaseGrids::halved(Angle angle) const
{
  PhaseGrids halved = *this;
  halved.*angle = (this->*angle).halved();
  return halved;
}

Eigen::VectorXd PhaseGrids::weights(const ring::Orientation &phase) const
{
  const Eigen::VectorXd of_glass = glass.weights(phase.glass), of_table = table.weights(phase.table);
  return (of_table * of_glass.transpose()).reshaped();
}

double torque_difference(const LeaningLoad &one, const LeaningLoad &other)
{
  const double radius = other.radius();
  double largest = 0;
  for (int quarter = -4; quarter <= 4; ++quarter)
  {
    const auto torque = [&](const LeaningLoad &load)
    { return ring::coulomb_wrench(1, load, quarter / 4., radius).torque; };
    largest = std::max(largest, std::abs(torque(one) - torque(other)));
  }
  return largest / (other.normal_force() * radius);
}

PhaseSamples::PhaseSamples(const PhaseGrids &grids, const Eigen::MatrixXd &columns, std::size_t n_rings)
    : grids(grids)
    , loads(columns)
    , rings_per_load(n_rings)
{
}

LeaningLoad PhaseSamples::mean() const
{
  const LeaningLoad mean = load_of(loads.rowwise().mean());
  if (mean.rings().size() > 1)
    return mean; // its radii are the same at every phase
  // M_N = pi R (b_1, -a_1): the radius that makes it the mean moment.
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (unsigned int i = 0; i < grids.size(); ++i)
    moment += sample(i).moment() / grids.size();
  const ring::RingStack::Ring &ring = mean.rings().front();
  const double first = mean.moment().norm() / ring.radius;
  if (first == 0)
    return mean;
  return { ring::RingStack(ring.a, ring.b, moment.norm() / first), mean.tilt };
}

SampleError PhaseSamples::error(PhaseGrids::Angle angle) const
{
  if ((grids.*angle).size() == 1)
    return {};
  const PhaseSamples half = halved(angle);
  const double of_half = error_of_half(angle), of_quarter = half.error_of_half(angle);
  return { torque_difference(half.mean(), mean()), of_half * std::min(1., of_half / of_quarter) };
}

SampleError PhaseSamples::error() const
{
  const SampleError of_glass = error(&PhaseGrids::glass), of_table = error(&PhaseGrids::table);
  return { of_glass.mean + of_table.mean, std::max(of_glass.between, of_table.between) };
}

LeaningLoad PhaseSamples::load_of(const Eigen::VectorXd &column) const
{
  return LeaningLoad::from_coefficients({ column.begin(), column.end() }, rings_per_load);
}

PhaseSamples PhaseSamples::halved(PhaseGrids::Angle angle) const
{
  const PhaseGrids half = grids.halved(angle);
  Eigen::MatrixXd kept(loads.rows(), half.size());
  for (unsigned int i = 0, k = 0; i < grids.size(); ++i)
    if (grids.node(angle, i) % 2 == 0)
      kept.col(k++) = loads.col(i);
  return { half, kept, rings_per_load };
}

double PhaseSamples::error_of_half(PhaseGrids::Angle angle) const
{
  const PhaseSamples half = halved(angle);
  double error = 0;
  for (unsigned int i = 0; i < grids.size(); ++i)
    if (grids.node(angle, i) % 2 == 1)
      error = std::max(error, torque_difference(half.at(grids.phase(i)), sample(i)));
  return error;
}

} // namespace stemware::pipeline
