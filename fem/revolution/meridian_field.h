#pragma once

#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/meridian_space.h"

#include <deal.II/base/quadrature.h>

#include <vector>

namespace stemware::fem
{

/// Displacement and stress in a body of revolution under forces on its contact circles, from displacement
/// harmonics of the meridian (docs/method/revolution.md, "Fields").
class MeridianField
{
public:
  /// Solves one meridional problem for each mode with force. Keeps a reference to @p space.
  MeridianField(const MeridianSpace &space, const ElasticMaterial &material, const ForceModes &forces);

  /// Amplitudes of all modes at points of one cell, cylindrical components, for FourierBasis::evaluate()
  /// (`in_phase`) and evaluate_conjugates() (`conjugate`).
  struct Amplitudes
  {
    std::vector<dealii::Point<2>> points; ///< (r, z) [m]
    /// Rows 6 p ... 6 p + 5 of point p: u_r, u_z [m], stresses rr, theta theta, zz, rz [Pa].
    Eigen::MatrixXd in_phase;
    /// Rows 3 p ... 3 p + 2 of point p: u_theta [m], stresses r theta, theta z [Pa].
    Eigen::MatrixXd conjugate;
  };

  /// Returns the amplitudes at points of the unit cell, mapped to @p cell; on the axis the limits r -> 0.
  Amplitudes amplitudes(const dealii::DoFHandler<2>::active_cell_iterator &cell,
                        const dealii::Quadrature<2> &unit_points) const;

  const MeridianSpace &space() const { return meridian; }
  const ElasticMaterial &material() const { return glass; }
  unsigned int n_modes() const { return static_cast<unsigned int>(displacements.size()); }

private:
  const MeridianSpace &meridian;
  const ElasticMaterial glass;
  std::vector<dealii::Vector<double>> displacements; ///< amplitudes per mode; empty for modes without force
};

} // namespace stemware::fem
