#include "fem/pipeline/coupling/phase_grids.h"

namespace stemware::pipeline
{

double PhaseGrids::turning_angle(const ring::Orientation &phase) const
{
  return glass.size() > 1 ? phase.glass : phase.table;
}

double PhaseGrids::turning_period() const
{
  return !turning ? 0 : glass.size() > 1 ? periods.glass : periods.table;
}

unsigned int PhaseGrids::n_turning_phases() const
{
  return glass.size() > 1 ? glass.size() : table.size();
}

ring::Orientation PhaseGrids::phase(unsigned int i) const
{
  return { glass.node(i / table.size()), table.node(i % table.size()) };
}

PhaseGrids PhaseGrids::halved() const
{
  PhaseGrids halved = *this;
  halved.glass = glass.halved();
  halved.table = table.halved();
  return halved;
}

Eigen::VectorXd PhaseGrids::weights(const ring::Orientation &phase) const
{
  const Eigen::VectorXd of_glass = glass.weights(phase.glass), of_table = table.weights(phase.table);
  return (of_table * of_glass.transpose()).reshaped(); // the table's angle runs fastest
}

} // namespace stemware::pipeline
