// The rigid table: complementarity at the contact nodes by an augmented Lagrangian.
#include "fem/contact/table_law.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

class RigidTable : public TableLaw
{
public:
  RigidTable(const ContactSurface &surface, double penalty)
      : surface(surface)
      , stiffness(penalty * surface.node_area)
      , multipliers(Eigen::VectorXd::Zero(surface.n_nodes()))
  {
  }

  void respond(const Eigen::VectorXd &approach, LawResponse &response) const override
  {
    response.forces = forces(approach);
    response.contact_set.resize(surface.n_nodes());
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
    {
      response.contact_set[i] = response.forces(i) > 0;
      if (response.forces(i) > 0)
        entries.emplace_back(i, i, stiffness(i));
    }
    response.tangent.resize(surface.n_nodes(), surface.n_nodes());
    response.tangent.setFromTriplets(entries.begin(), entries.end());
  }

  TableLoad load(const Eigen::VectorXd &approach) const override
  {
    const Eigen::VectorXd nodal = forces(approach);
    TableLoad result;
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (nodal(i) > 0)
        result.points.push_back({ surface.node_position(i, 0), surface.node_position(i, 1), nodal(i) });
    result.density = density_of_nodes(surface, nodal);
    return result;
  }

  Footprint footprint(const Eigen::VectorXd &approach) const override
  {
    return footprint_of_nodes(surface, nodal_pressure(approach));
  }

  Eigen::VectorXd nodal_pressure(const Eigen::VectorXd &approach) const override
  {
    return forces(approach).cwiseQuotient(surface.node_area);
  }

  double update_multipliers(const Eigen::VectorXd &approach) override
  {
    const Eigen::VectorXd updated = forces(approach);
    // f - multiplier is stiffness * penetration where loaded, and what the node should have let go of where
    // not.
    const double violation = ((updated - multipliers).array() / stiffness.array()).abs().maxCoeff();
    multipliers = updated;
    return violation;
  }

private:
  Eigen::VectorXd forces(const Eigen::VectorXd &approach) const
  {
    return (multipliers - stiffness.cwiseProduct(surface.node_gap + approach)).cwiseMax(0.);
  }

  const ContactSurface &surface;
  const Eigen::VectorXd stiffness; ///< penalty times nodal area [N/m]
  Eigen::VectorXd multipliers;     ///< nodal forces [N]
};

} // namespace

std::unique_ptr<TableLaw> make_rigid_table(const ContactSurface &surface, double penalty)
{
  if (!(std::isfinite(penalty) && penalty > 0))
  {
    std::ostringstream message;
    message << "The penalty of a rigid table, " << penalty
            << " Pa/m, must be a finite number greater than 0.";
    throw std::invalid_argument(message.str());
  }
  return std::make_unique<RigidTable>(surface, penalty);
}

} // namespace stemware::fem
