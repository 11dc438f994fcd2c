#pragma once

#include "ring_model/motion.h"

#include <Eigen/Core>

namespace stemware::ring
{
/// Coefficient of friction that depends on the local slip speed.
///
///     const StribeckLaw law(0.4, 0.3, 0.1); // mu_s, mu_k, decay speed [m/s]
///     const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega, v);
///     friction(load).torque; // tau_z [N m]
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;

  /// Returns mu at the slip speed |v_rel| >= 0 [m/s].
  virtual double coefficient(double slip_speed) const = 0;

  /// Returns whether the coefficient is the same at every speed, so that the exact kernels apply.
  virtual bool is_constant() const { return false; }
};

/// Stribeck: mu = kinetic + (static - kinetic) exp(-(|v_rel| / decay_speed)^decay_exponent) + viscous |v_rel|
class StribeckLaw : public FrictionLaw
{
public:
  /// Creates the law. @p static_coefficient: limit for vanishing slip. @p kinetic_coefficient: plateau at
  /// high slip speed. @p decay_speed [m/s]. @p viscous: growth with the slip speed [s/m]. @p decay_exponent:
  /// 1 for Tustin's law, 2 for a Gaussian decay. Throws std::invalid_argument if a coefficient is negative,
  /// or decay speed or exponent not positive.
  StribeckLaw(double static_coefficient, double kinetic_coefficient, double decay_speed, double viscous = 0.,
              double decay_exponent = 2.);
  double coefficient(double slip_speed) const override;
  bool is_constant() const override;

private:
  double static_coefficient, kinetic_coefficient, decay_speed, viscous, decay_exponent;
};

/// Returns Coulomb's law: one coefficient @p mu. Throws std::invalid_argument if it is negative.
inline StribeckLaw coulomb_law(double mu)
{
  return { mu, mu, 1. };
}

/// Returns the friction law of @p motion.
StribeckLaw friction_law_of(const Motion &motion);

/// Returns the integrals of friction under @p law over a ring, per unit of load. The rim turns with @p
/// rim_speed = omega r [m/s] and slides with @p speed [m/s]. Shape [n_max + 1, 3], the columns torque over r,
/// drag and side: mu (K_n, U_n, -n P_n) by the exact FrictionKernels for a constant coefficient, else by
/// quadrature, refined until the columns agree to 1e-12 of the largest value (docs/theory/friction_laws.md).
/// Throws std::invalid_argument as FrictionKernels, std::runtime_error if the refinement does not end.
Eigen::ArrayX3d friction_kernels(const FrictionLaw &law, double rim_speed, double speed, unsigned int n_max);
} // namespace stemware::ring
