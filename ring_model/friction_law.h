#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/motion.h"

#include <vector>

namespace stemware::ring
{
/// Coefficient of friction that depends on the local slip speed.
///
///     const StribeckLaw law({ 0.4, 0.3, 0.1 }); // mu_s, mu_k, decay speed [m/s]
///     const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega, v);
///     friction(load).torque; // tau_z [N m]
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;

  /// mu at the slip speed |v_rel| >= 0 [m/s].
  virtual double coefficient(double slip_speed) const = 0;

  /// Returns whether the coefficient is the same at every speed, so that the exact kernels apply.
  virtual bool is_constant() const { return false; }
};

/**
 * Stribeck's law: mu = kinetic + (static - kinetic) exp(-(|v_rel| / decay_speed)^decay_exponent) + viscous
 * |v_rel|. Exponent 1 is Tustin's form, 2 the usual one.
 */
class StribeckLaw : public FrictionLaw
{
public:
  struct Parameters
  {
    double static_coefficient;  ///< limit for vanishing slip
    double kinetic_coefficient; ///< plateau at high slip speed
    double decay_speed;         ///< [m/s]
    double viscous = 0.;        ///< growth with the slip speed [s/m]
    double decay_exponent = 2.;
  };

  /// @throws std::invalid_argument if a coefficient is negative or the decay speed or exponent is not
  /// positive.
  explicit StribeckLaw(const Parameters &parameters);
  double coefficient(double slip_speed) const override;
  bool is_constant() const override;

private:
  Parameters parameters;
};

/// Returns the friction law of @p motion; Coulomb's is Stribeck's with equal coefficients.
StribeckLaw friction_law_of(const Motion &motion);

/**
 * Returns the functionals T_x, T_y and tau_z of a stack under @p law: friction is linear in the load even if
 * its coefficient depends on the slip. Exact kernels for a constant coefficient, else quadrature of all
 * harmonics at once, refined until the coefficients agree to 1e-12 of the largest.
 * docs/theory/friction_laws.md.
 *
 * @throws std::invalid_argument as friction_functionals() of a constant coefficient, std::runtime_error if
 * the refinement does not end.
 */
FrictionFunctionals friction_functionals(const FrictionLaw &law, const std::vector<double> &radii,
                                         unsigned int n_max, double omega, double speed);

/// Returns friction_functionals() under the law of @p motion, at its orbit speed.
FrictionFunctionals friction_functionals(const Motion &motion, const std::vector<double> &radii,
                                         unsigned int n_max, double omega);

/// Returns the friction on a stack of rings under the law of @p motion, at its orbit speed. @throws as
/// friction_functionals().
Wrench wrench(const Motion &motion, const RingStack &load, double omega);

/**
 * Returns an a-priori bound [N m] on the change of tau_z under the law of @p motion if the harmonics above @p
 * n_max are left out: sum_j sum_{n > n_max} |lambda_{j,n}| |K_{j,n}|, where |lambda_{j,n}| = sqrt(a_{j,n}^2 +
 * b_{j,n}^2) and |K_{j,n}| is the torque functional's coefficient, mu r_j |K_n(eps_j)| for Coulomb.
 */
double truncation_bound(const Motion &motion, const RingStack &load, unsigned int n_max, double omega);
} // namespace stemware::ring
