#include "ring_model/spin/phase_torque.h"

#include "ring_model/spin/answer.h"

#include <algorithm>
#include <vector>

namespace stemware::ring
{

PhaseTorque::PhaseTorque(const Load &load, const Motion &motion, double middle, double reach,
                         double tolerance)
    : load(load)
    , motion(motion)
    , grids(load.phases()->phases())
{
  // A ring's kink at v / R may lie within reach, but not next to the spins that the glass turns with.
  constexpr unsigned int max_trials = 3;
  // Beyond the spins that the load is known between it would take contact solutions, and has a kink.
  const auto [slowest, fastest] = load.phases()->polynomial_range(middle);
  for (unsigned int trial = 0; trial < max_trials && !spins; ++trial, reach /= 2)
  {
    lower = std::max(middle - reach, slowest);
    upper = std::min(middle + reach, fastest);
    if (lower < upper)
      tabulate(tolerance);
  }
}

void PhaseTorque::tabulate(double tolerance)
{
  constexpr unsigned int first_steps = 4, max_steps = 16;
  for (ChebyshevInterval tried(lower, upper, first_steps); tried.size() <= max_steps + 1;
       tried = tried.refined())
  {
    const std::vector<double> places = tried.between();
    const Eigen::MatrixXd torques = at_phases(tried.nodes()), between = at_phases(places);
    double error = 0.;
    for (unsigned int k = 0; k < places.size(); ++k)
      error =
        std::max(error, (torques * tried.weights(places[k]) - between.col(k)).lpNorm<Eigen::Infinity>());
    if (error <= tolerance)
    {
      spins = tried;
      table = torques;
      return;
    }
  }
}

double PhaseTorque::operator()(double time, double yaw_angle, double omega) const
{
  const Orientation marks = orientation_of_marks(motion, time, yaw_angle);
  if (!spins || omega < lower || omega > upper)
    return yaw_torque(load, motion, omega, marks);
  return grids.weights(marks).dot(table * spins->weights(omega));
}

Eigen::MatrixXd PhaseTorque::at_phases(const std::vector<double> &omegas) const
{
  Eigen::MatrixXd torques(grids.size(), omegas.size());
  for (unsigned int k = 0; k < omegas.size(); ++k)
    for (unsigned int i = 0; i < grids.size(); ++i)
      torques(i, k) = yaw_torque(load, motion, omegas[k], grids.phase(i));
  return torques;
}

} // namespace stemware::ring
