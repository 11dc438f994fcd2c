#include "ring_model/spin/phases.h"

#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::ring
{

Orientation orientation_of_marks(const Motion &motion, double time, double yaw_angle)
{
  const double behind = motion.orbit_rate() * time + motion.sense_sign() * pi / 2;
  return { yaw_angle - behind, -behind };
}

PeriodicGrid::PeriodicGrid(double period, unsigned int n_nodes)
    : period(period)
    , n_nodes(n_nodes)
{
  if (!(period > 0) || n_nodes == 0 || (n_nodes > 1 && n_nodes % 2 == 1))
    throw std::logic_error("a periodic grid has a positive period and one or an even number of nodes");
  const Eigen::ArrayXd halves = Eigen::ArrayXd::LinSpaced(n_nodes, 0, n_nodes - 1) * (pi / n_nodes);
  cosine = halves.cos();
  sine = halves.sin();
}

PeriodicGrid PeriodicGrid::halved() const
{
  return PeriodicGrid(period, n_nodes > 1 ? n_nodes / 2 : 1);
}

Eigen::VectorXd PeriodicGrid::weights(double angle) const
{
  if (n_nodes == 1)
    return Eigen::VectorXd::Ones(1);
  // Barycentric trigonometric interpolation with an even number of nodes: weights (-1)^i cot((x - x_i) / 2)
  // with x = 2 pi angle / period.
  const double half = pi * angle / period, of_cosine = std::cos(half), of_sine = std::sin(half);
  const Eigen::ArrayXd distance = of_sine * cosine - of_cosine * sine;
  Eigen::Index nearest = 0;
  if (distance.abs().minCoeff(&nearest) < 1e-14)
    return Eigen::VectorXd::Unit(n_nodes, nearest);
  Eigen::VectorXd values = (of_cosine * cosine + of_sine * sine) / distance;
  for (unsigned int i = 1; i < n_nodes; i += 2)
    values(i) = -values(i);
  return values / values.sum();
}

Orientation PhaseGrids::phase(unsigned int i) const
{
  return { glass.node(node(&PhaseGrids::glass, i)), table.node(node(&PhaseGrids::table, i)) };
}

unsigned int PhaseGrids::node(Angle angle, unsigned int i) const
{
  return angle == &PhaseGrids::glass ? i / table.size() : i % table.size();
}

Eigen::VectorXd PhaseGrids::weights(const Orientation &phase) const
{
  const Eigen::VectorXd of_glass = glass.weights(phase.glass), of_table = table.weights(phase.table);
  return (of_table * of_glass.transpose()).reshaped();
}

double torque_difference(const Sample &one, const Sample &other)
{
  const double radius = other.radius();
  double largest = 0;
  for (int quarter = -4; quarter <= 4; ++quarter)
  {
    const auto torque = [&](const Sample &load)
    { return coulomb_wrench(1, load, quarter / 4., radius).torque; };
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

Sample PhaseSamples::at(const Orientation &phase) const
{
  const Eigen::VectorXd weights = grids.weights(phase);
  Eigen::Index nearest = 0;
  if (weights.maxCoeff(&nearest) == 1 && weights.lpNorm<1>() == 1)
    return sample(static_cast<unsigned int>(nearest));
  return load_of(loads * weights);
}

Sample PhaseSamples::mean() const
{
  const Sample mean = load_of(loads.rowwise().mean());
  if (mean.rings().size() > 1)
    return mean;
  // The moment pi R (b_1, -a_1) is proportional to R, so R is scaled to the norm of the mean moment.
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (unsigned int i = 0; i < grids.size(); ++i)
    moment += sample(i).moment() / grids.size();
  const RingStack::Ring &ring = mean.rings().front();
  const double first = mean.moment().norm() / ring.radius;
  if (first == 0)
    return mean;
  return { RingStack(ring.a, ring.b, moment.norm() / first), mean.tilt };
}

SampleError PhaseSamples::error(PhaseGrids::Angle angle) const
{
  if ((grids.*angle).size() == 1)
    return {};
  const PhaseSamples half = halved(angle), quarter = half.halved(angle);
  // The error decreases geometrically with the number of phases, from the half to all by at least 1 / safety
  // of the decrease from the quarter to the half. The error of the mean may be small by chance if the load
  // jumps.
  const auto error_of_all = [](double of_half, double of_quarter, double safety)
  { return of_half * std::min(1., safety * of_half / of_quarter); };
  return { error_of_all(torque_difference(half.mean(), mean()),
                        torque_difference(quarter.mean(), half.mean()), 4),
           error_of_all(error_of_half(angle), half.error_of_half(angle), 1) };
}

SampleError PhaseSamples::error() const
{
  const SampleError of_glass = error(&PhaseGrids::glass), of_table = error(&PhaseGrids::table);
  return { of_glass.mean + of_table.mean, std::max(of_glass.between, of_table.between) };
}

PhaseSamples PhaseSamples::halved(PhaseGrids::Angle angle) const
{
  PhaseGrids half = grids;
  half.*angle = (grids.*angle).halved();
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

} // namespace stemware::ring
