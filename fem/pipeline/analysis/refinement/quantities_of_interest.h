#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A quantity whose discretisation error is estimated.
struct QuantityOfInterest
{
  std::string key;  ///< in summary.json: "omega_terminal"
  std::string name; ///< for people: "terminal spin"
  std::string unit; ///< "1" for pure numbers
  double value = 0;
  double rounding = 0; ///< differences of this size are those of solver tolerances, not of a discretisation
};

/// A quantity of the study with its error band.
struct BandedQuantity
{
  QuantityOfInterest quantity;
  double band = 0;       ///< half-width: the exact value of the model lies within quantity.value -/+ band
  double richardson = 0; ///< the value with the errors of all axes taken away as far as they are known
  std::map<std::string, double> parts = {}; ///< what the band is made of, by its cause: "mesh", "degree", ...

  /// True if the value is zero to within rounding, as that of a harmonic which symmetry forbids.
  bool is_zero() const;
};

/// Error bands of a study's quantities; empty where they were not estimated.
using ErrorBands = std::vector<BandedQuantity>;

/// Size of the differences that the tolerances of contacts and balances make, relative to the mean load.
constexpr double relative_noise = 1e-9;

/// The numbers of a spin that are followed besides those of the load at rest.
struct SpinNumbers
{
  double torque_at_rest = 0;   ///< tau_z [N m]
  std::vector<double> spins;   ///< at which the torque is followed too [rad/s]
  std::vector<double> torques; ///< tau_z there [N m]
  double omega_terminal = 0;   ///< [rad/s]
  double time_constant = 0;    ///< [s]
  // Scales of rounding:
  double radius = 0;      ///< of friction [m]
  double spin_scale = 0;  ///< [rad/s]
  double slope_noise = 1; ///< of the time constant, over that of the torque whose slope it is
};

/// Quantities of a load: a_n/a_0 and b_n/a_0 (n = 1 ... 8), ring radius, contact fraction, least load. With
/// lift-off the contact fraction is known to @p share_noise.
std::vector<QuantityOfInterest> load_quantities(const LoadReport &load, double share_noise = relative_noise);

/// The quantities that are followed: load_quantities() @p at_rest, torque at rest and at SpinNumbers::spins,
/// terminal spin, time constant. Always the same ones in the same order for equally many spins.
std::vector<QuantityOfInterest> quantities_of_interest(const Study &study, const LoadReport &at_rest,
                                                       const SpinNumbers &spin);

/// Quantities of a study whose load is known, with the torque at @p spins [rad/s]. @p near is a spin close to
/// the terminal one, from which it is searched. Throws as @p load and ring::terminal_spin().
std::vector<QuantityOfInterest> quantities_of_load(const Study &study, const BalancedLoad &load,
                                                   const std::vector<double> &spins,
                                                   const std::optional<double> &near);

/// Terminal spin of @p answer [rad/s]. Throws its failure, and ring::NoBalance if the glass falls over.
double terminal_spin_of(const ring::Answer &answer);

/// Default spins at which the torque is evaluated: half and one and a half times
/// the terminal spin @p omega_terminal.
std::vector<double> spins_of_interest(double omega_terminal);

/// Highest harmonic that is followed.
constexpr unsigned int n_harmonics_of_interest = 8;

/// The quantity with that key; throws std::out_of_range when there is none.
const QuantityOfInterest &quantity_of(const std::vector<QuantityOfInterest> &quantities,
                                      const std::string &key);

/// Returns the change of the quantity @p key from @p before to @p after: terminal spin and torques at a
/// spin are judged together, by the largest change of torque at half, at all and at one and a half times the
/// terminal spin; NaN where one of the three has no value. What a mesh does to different harmonics may cancel
/// at one spin, hardly at all three. @p yaw_inertia [kg m^2]. Throws as quantity_of().
double max_change_over_spins(const std::string &key, const std::vector<QuantityOfInterest> &before,
                             const std::vector<QuantityOfInterest> &after, double yaw_inertia);

/// Key of the quantity that is the goal of a mesh; empty for none.
std::string key_of(Goal goal);

/// The quantity with that key; end() where there is none.
ErrorBands::const_iterator find_quantity(const ErrorBands &quantities, const std::string &key);

/// Position of the quantity with that key; throws std::out_of_range where there is none.
std::size_t index_of(const ErrorBands &quantities, const std::string &key);

/// The half-width of the error band of the quantity with that key; nothing where there is no such quantity.
std::optional<double> band_of(const ErrorBands &quantities, const std::string &key);

} // namespace stemware::pipeline
