#pragma once

#include "ring_model/coulomb_ring.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/motion.h"

#include <vector>

namespace stemware::ring
{
/// A coefficient of friction that depends on the local slip speed.
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;

  /// mu at the slip speed |v_rel| >= 0 [m/s].
  virtual double coefficient(double slip_speed) const = 0;

  /// Whether the coefficient is the same at every speed: then the exact kernels serve.
  virtual bool is_constant() const { return false; }
};

/// mu = const.
class CoulombLaw : public FrictionLaw
{
public:
  /// @throws std::invalid_argument unless mu >= 0.
  explicit CoulombLaw(double friction_coefficient);
  double coefficient(double /*slip_speed*/) const override { return mu; }
  bool is_constant() const override { return true; }

private:
  double mu;
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

/// A wrench with bounds on its error.
struct EstimatedWrench
{
  Wrench value;
  Wrench error; ///< estimated absolute error of each component, >= 0; zero where the kernels served
};

/// The law of a motion; Coulomb's is Stribeck's with equal coefficients.
StribeckLaw friction_law_of(const Motion &motion);

/**
 * T_x, T_y and tau_z of a stack as functions of its load under @p law: friction stays linear in the load when
 * its coefficient depends on the slip. By the kernels where the law is constant, else by quadrature of all
 * harmonics at once, refined until the coefficients agree to 1e-12 of the largest.
 * docs/theory/friction_laws.md.
 *
 * @throws std::invalid_argument as friction_functionals() of a constant coefficient, std::runtime_error where
 * the refinement does not end.
 */
FrictionFunctionals friction_functionals(const FrictionLaw &law, const std::vector<double> &radii,
                                         unsigned int n_max, double omega, double speed);

/// friction_functionals() under the law of @p motion, at its orbit speed.
FrictionFunctionals friction_functionals(const Motion &motion, const std::vector<double> &radii,
                                         unsigned int n_max, double omega);

/// Friction on a stack of rings under the law of @p motion, at its orbit speed: the one place where a load
/// becomes a torque and a force. @throws as friction_functionals().
Wrench wrench(const Motion &motion, const RingStack &load, double omega);

/// CoulombRing::truncation_bound() under the law of @p motion [N m].
double truncation_bound(const Motion &motion, const RingStack &load, unsigned int n_max, double omega);

/**
 * Torque and friction force of one ring under @p law: by the kernels if it is constant, else by adaptive
 * Gauss-Kronrod quadrature in a variable that resolves the point of least slip at every slip ratio. It says
 * how well, and shares no quadrature with friction_functionals(). docs/theory/friction_laws.md.
 *
 * @param omega     Spin [rad/s].
 * @param speed     Sliding speed v >= 0 [m/s].
 * @param tolerance Requested relative accuracy (of mu N and mu N R).
 * @throws std::invalid_argument if a value is not allowed, the ring neither slides nor spins, or there are
 *         several rings under a law that is not constant,
 *         std::runtime_error if the error estimate stays above ten times the tolerance.
 */
EstimatedWrench wrench(const FrictionLaw &law, const RingStack &load, double omega, double speed,
                       double tolerance = 1e-12);
} // namespace stemware::ring
