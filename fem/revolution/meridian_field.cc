#include "fem/revolution/meridian_field.h"

#include "fem/revolution/parallel_for.h"

#include <deal.II/fe/fe_values.h>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Displacement (r, theta, z) of one mode at one point, and its derivatives with respect to r and z.
struct PointValue
{
  Tensor<1, 3> value;
  std::array<Tensor<1, 2>, 3> gradient;
};

PointValue value_at(const FEValues<2> &fe_values, unsigned int q, const Vector<double> &displacement,
                    const std::vector<MeridianSpace::Dof> &dofs)
{
  PointValue at;
  for (unsigned int i = 0; i < dofs.size(); ++i)
  {
    const unsigned int component = fe_values.get_fe().system_to_component_index(i).first;
    const double amplitude = displacement(dofs[i]);
    at.value[component] += amplitude * fe_values.shape_value(i, q);
    at.gradient[component] += amplitude * fe_values.shape_grad(i, q);
  }
  return at;
}

} // namespace

MeridianField::MeridianField(const MeridianSpace &space, const ElasticMaterial &material,
                             const ForceModes &forces)
    : meridian(space)
    , glass(material)
    , displacements(static_cast<std::size_t>(forces.normal.cols()))
{
  const bool has_sliding = forces.radial.size() > 0;
  const auto is_loaded = [&](unsigned int mode)
  {
    return !forces.normal.col(mode).isZero(0) ||
           (has_sliding && !(forces.radial.col(mode).isZero(0) && forces.azimuthal.col(mode).isZero(0)));
  };
  const auto solve = [&](unsigned int mode, const MeridianSpace::Factors &factors)
  {
    Vector<double> &displacement = displacements[mode];
    displacement.reinit(space.n_dofs());
    const double norm = FourierBasis::norm(mode);
    for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    {
      const MeridianSpace::NodeDofs &node = space.contact_dofs(i);
      displacement(node[2]) = forces.normal(i, mode) / norm;
      if (!has_sliding)
        continue;
      displacement(node[0]) = forces.radial(i, mode) / norm;
      displacement(node[1]) = forces.azimuthal(i, mode) / norm;
    }
    factors.solve(displacement);
  };
  const auto solve_harmonic = [&](unsigned int n)
  {
    for (unsigned int mode = n == 0 ? 0 : 2 * n - 1; mode <= 2 * n; ++mode)
      if (is_loaded(mode))
        solve(mode, space.factors(n));
  };
  parallel_for((n_modes() + 1) / 2, solve_harmonic);
}

MeridianField::Amplitudes MeridianField::amplitudes(const DoFHandler<2>::active_cell_iterator &cell,
                                                    const Quadrature<2> &unit_points) const
{
  FEValues<2> fe_values(meridian.mapping(), meridian.dof_handler().get_fe(), unit_points,
                        update_values | update_gradients | update_quadrature_points);
  fe_values.reinit(cell);
  const unsigned int n_points = unit_points.size();
  Amplitudes result;
  result.points = fe_values.get_quadrature_points();
  result.in_phase = Eigen::MatrixXd::Zero(6 * n_points, n_modes());
  result.conjugate = Eigen::MatrixXd::Zero(3 * n_points, n_modes());
  std::vector<MeridianSpace::Dof> dofs(fe_values.dofs_per_cell);
  cell->get_dof_indices(dofs);
  const double lambda = glass.lame_lambda();
  const double shear = glass.shear_modulus();
  const double on_axis = 1e-9 * meridian.contact_radius(0);
  for (unsigned int mode = 0; mode < n_modes(); ++mode)
  {
    if (displacements[mode].size() == 0)
      continue;
    const double n = FourierBasis::harmonic(mode);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const PointValue at = value_at(fe_values, q, displacements[mode], dofs);
      const double radius = result.points[q][0];
      // On the axis the numerator and r vanish, so the quotient is the derivative of the numerator.
      const auto over_radius = [&](double u_r, double u_theta, double u_z)
      {
        const auto sum = [&](double r, double theta, double z)
        { return u_r * r + u_theta * theta + u_z * z; };
        return radius > on_axis ? sum(at.value[0], at.value[1], at.value[2]) / radius
                                : sum(at.gradient[0][0], at.gradient[1][0], at.gradient[2][0]);
      };
      const double strain_rr = at.gradient[0][0];
      const double strain_tt = over_radius(1, n, 0);
      const double strain_zz = at.gradient[2][1];
      const double volume = lambda * (strain_rr + strain_tt + strain_zz);
      result.in_phase.block<6, 1>(6 * q, mode) << at.value[0], at.value[2], volume + 2 * shear * strain_rr,
        volume + 2 * shear * strain_tt, volume + 2 * shear * strain_zz,
        shear * (at.gradient[0][1] + at.gradient[2][0]);
      result.conjugate.block<3, 1>(3 * q, mode) << at.value[1],
        shear * (at.gradient[1][0] - over_radius(n, 1, 0)),
        shear * (at.gradient[1][1] - over_radius(0, 0, n));
    }
  }
  return result;
}

} // namespace stemware::fem
