#include "fem/revolution/harmonic_stiffness.h"

namespace stemware::fem
{

namespace
{

/// One column of strains per field, in the order rr, zz, theta theta, rz, r theta, z theta (engineering shear
/// strains).
using StrainOfFields = Eigen::Matrix<double, 6, HarmonicStiffness::n_fields>;

/// Strain of harmonic n of a displacement component: `constant` + n `linear`.
struct ComponentStrain
{
  StrainOfFields constant = StrainOfFields::Zero();
  StrainOfFields linear = StrainOfFields::Zero();
};

std::array<ComponentStrain, 3> strains_of_components()
{
  enum
  {
    rr,
    zz,
    tt,
    rz,
    rt,
    zt
  };
  enum
  {
    along_r,
    along_z,
    over_r
  };
  std::array<ComponentStrain, 3> strains;
  auto &[radial, azimuthal, vertical] = strains;
  radial.constant(rr, along_r) = radial.constant(tt, over_r) = radial.constant(rz, along_z) = 1;
  radial.linear(rt, over_r) = -1;
  azimuthal.constant(rt, along_r) = azimuthal.constant(zt, along_z) = 1;
  azimuthal.constant(rt, over_r) = -1;
  azimuthal.linear(tt, over_r) = 1;
  vertical.constant(zz, along_z) = vertical.constant(rz, along_r) = 1;
  vertical.linear(zt, over_r) = -1;
  return strains;
}

} // namespace

HarmonicStiffness::HarmonicStiffness(const ElasticMaterial &material)
{
  Eigen::Matrix<double, 6, 6> moduli = Eigen::Matrix<double, 6, 6>::Zero();
  moduli.topLeftCorner<3, 3>().setConstant(material.lame_lambda());
  moduli.diagonal().head<3>().array() += 2 * material.shear_modulus();
  moduli.diagonal().tail<3>().setConstant(material.shear_modulus());
  const auto strains = strains_of_components();
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t d = 0; d < 3; ++d)
    {
      const ComponentStrain &a = strains[c], &b = strains[d];
      coefficients[0][c][d] = a.constant.transpose() * moduli * b.constant;
      coefficients[1][c][d] =
        a.constant.transpose() * moduli * b.linear + a.linear.transpose() * moduli * b.constant;
      coefficients[2][c][d] = a.linear.transpose() * moduli * b.linear;
    }
}

std::array<Eigen::MatrixXd, 3> HarmonicStiffness::parts(const Eigen::MatrixXd &products) const
{
  const Eigen::Index m = products.rows() / n_fields;
  std::array<Eigen::MatrixXd, 3> parts;
  Eigen::MatrixXd block(m, m);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    parts[k].resize(3 * m, 3 * m);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
      {
        block.setZero();
        const Eigen::Matrix3d &factors = coefficients[k][c][d];
        for (Eigen::Index p = 0; p < n_fields; ++p)
          for (Eigen::Index q = 0; q < n_fields; ++q)
            if (factors(p, q) != 0)
              block += factors(p, q) * products.block(p * m, q * m, m, m);
        for (Eigen::Index j = 0; j < m; ++j)
          for (Eigen::Index i = 0; i < m; ++i)
            parts[k](3 * i + static_cast<Eigen::Index>(c), 3 * j + static_cast<Eigen::Index>(d)) =
              block(i, j);
      }
  }
  return parts;
}

} // namespace stemware::fem
