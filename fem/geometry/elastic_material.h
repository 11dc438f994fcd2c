#pragma once

namespace stemware::fem
{

/// Isotropic linear elasticity, sigma = lambda tr(eps) I + 2 mu eps.
struct ElasticMaterial
{
  double young_modulus = 70e9; ///< E [Pa], > 0
  double poisson_ratio = 0.22; ///< nu, in (-1, 1/2)

  /// Returns the first Lame constant E nu / ((1 + nu)(1 - 2 nu)) [Pa].
  double lame_lambda() const
  {
    return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  }
  /// Returns the shear modulus E / (2 (1 + nu)) [Pa].
  double shear_modulus() const { return young_modulus / (2 * (1 + poisson_ratio)); }

  /// Throws std::invalid_argument if E or nu is outside its range or not finite.
  void validate() const;
};

} // namespace stemware::fem
