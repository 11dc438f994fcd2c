#include "fem/contact/hard_interface.h"

#include <algorithm>

namespace stemware::fem
{

namespace
{

class HardContact : public TableLaw
{
public:
  HardContact(const ContactSurface &surface, double penalty)
      : surface(surface)
      , stiffness(penalty * own_areas(surface))
      , multipliers(Eigen::VectorXd::Zero(surface.n_nodes()))
  {
  }

  void evaluate(const Eigen::VectorXd &normal_displacement, ContactForces &contact) const override
  {
    contact.forces = forces(normal_displacement);
    contact.active_set.resize(surface.n_nodes());
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
    {
      contact.active_set[i] = contact.forces(i) > 0;
      if (contact.forces(i) > 0)
        entries.emplace_back(i, i, stiffness(i));
    }
    contact.tangent.resize(surface.n_nodes(), surface.n_nodes());
    contact.tangent.setFromTriplets(entries.begin(), entries.end());
  }

  TableLoad load(const ContactSolution &solution, unsigned int /*n_parts*/) const override
  {
    const Eigen::VectorXd &nodal = solution.forces;
    TableLoad result;
    result.parts = surface.parts;
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (nodal(i) > 0)
        result.points.push_back({ surface.node_position(i, 0), surface.node_position(i, 1), nodal(i) });
    result.density = density_of_nodes(surface, nodal);
    return result;
  }

  ContactExtent extent(const ContactSolution &solution) const override
  {
    const Eigen::Index n = surface.n_owned_nodes();
    const auto areas = surface.node_area.head(n).array();
    const auto own = solution.forces.head(n).array();
    const double loaded = ContactExtent::rounding_share * surface.parts.max_entry(own);
    ContactExtent extent;
    extent.peak_pressure = surface.parts.max_entry(own / areas);
    const std::vector<AzimuthValue> density = density_of_nodes(surface, solution.forces);
    const auto n_loaded = std::count_if(density.begin(), density.end(),
                                        [&](const AzimuthValue &sector) { return sector.value > loaded; });
    const double azimuth_share = static_cast<double>(n_loaded) / static_cast<double>(density.size());
    if (surface.is_ring)
      extent.azimuth_share = azimuth_share;
    const double unloaded_area = surface.parts.sum((own > loaded).select(0, areas).sum());
    extent.area_share = surface.is_crowned ? azimuth_share : 1 - std::min(1., unloaded_area / surface.area());
    return extent;
  }

  PressureMap pressure_map(const ContactSolution &solution) const override
  {
    return pressure_map_of_nodes(surface, nodal_pressure(solution));
  }

  Eigen::VectorXd nodal_pressure(const ContactSolution &solution) const override
  {
    return solution.forces.cwiseQuotient(surface.node_area);
  }

  void set_multipliers(const Eigen::VectorXd &forces) override
  {
    multipliers = forces.size() > 0 ? forces : Eigen::VectorXd::Zero(surface.n_nodes());
  }

  double augmented_lagrangian_update(const Eigen::VectorXd &normal_displacement) override
  {
    const Eigen::VectorXd updated = forces(normal_displacement);
    // |updated - multipliers| / stiffness is the penetration of a loaded node. For an unloaded node it is the
    // previous multiplier, expressed as a length.
    const Eigen::Index n = surface.n_owned_nodes();
    const double violation =
      surface.parts.max_entry(((updated - multipliers).head(n).array() / stiffness.head(n).array()).abs());
    multipliers = updated;
    return violation;
  }

private:
  /// Returns the nodal areas, with 0 at ghost nodes: their areas belong to another part of the surface.
  static Eigen::VectorXd own_areas(const ContactSurface &surface)
  {
    Eigen::VectorXd areas = surface.node_area;
    areas.tail(surface.n_ghost_nodes).setZero();
    return areas;
  }

  Eigen::VectorXd forces(const Eigen::VectorXd &normal_displacement) const
  {
    return (multipliers - stiffness.cwiseProduct(surface.node_gap + normal_displacement)).cwiseMax(0.);
  }

  const ContactSurface &surface;
  const Eigen::VectorXd stiffness; ///< penalty times nodal area [N/m]
  Eigen::VectorXd multipliers;     ///< nodal forces [N]
};

} // namespace

std::unique_ptr<TableLaw> HardInterface::make(const ContactSurface &surface, double penalty) const
{
  require_positive("Penalty of a hard interface", penalty, "Pa/m", "Young's modulus over the cell size");
  return std::make_unique<HardContact>(surface, penalty);
}

} // namespace stemware::fem
