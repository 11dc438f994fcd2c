#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Quantity whose discretisation error is estimated.
struct QuantityOfInterest
{
  std::string key;  ///< key in error_bands: of a declared Quantity, or "tau_at_spin_1", "table_motion_0"
  std::string name; ///< displayed name, "terminal spin"; a * stands for `omega`
  std::string unit; ///< "1" for pure numbers
  double value = 0;
  double rounding = 0;              ///< differences due to solver tolerances
  std::optional<double> omega = {}; ///< spin of a torque [rad/s]

  /// Returns the name with `omega` in it.
  std::string title() const;
};

/// A quantity of the study with its error band.
struct BandedQuantity
{
  QuantityOfInterest quantity;
  double band = 0;                          ///< half-width: the exact value is within quantity.value -/+ band
  double richardson = 0;                    ///< value minus the estimated errors of all axes
  std::map<std::string, double> parts = {}; ///< parts of the band by cause: "mesh", "degree", ...

  /// Widens the band and its part @p part by @p half_width.
  void add(const std::string &part, double half_width)
  {
    parts[part] += half_width;
    band += half_width;
  }

  /// Returns true if the value is zero to rounding (a harmonic that vanishes by symmetry).
  bool is_zero() const;
};

/// Error bands of a study's quantities; empty if not estimated.
using ErrorBands = std::vector<BandedQuantity>;

/// Size of differences due to the tolerances of contacts and balances, relative to the mean load.
constexpr double relative_noise = 1e-9;

/// Returns the load_fields() with a name in bands and a value. With lift-off, fractions are accurate to @p
/// share_noise.
std::vector<QuantityOfInterest> load_quantities(const LoadReport &load, double share_noise = relative_noise);

/// Returns the quantity @p key of study_quantities(), which has a name in bands. Throws std::out_of_range if
/// there is none.
QuantityOfInterest spin_quantity(const std::string &key, double value, double rounding);

/// Returns load_quantities() @p at_rest, the answer_fields() of @p answer with a name in bands (NaN if
/// missing), the @p torques of friction by spin [rad/s, N m], and @p table_motion at rest (q_0 [m], q_1 and
/// q_2 [rad]). Keys and order are equal for equally many torques and the same values in
/// @p at_rest.
std::vector<QuantityOfInterest> quantities_of_interest(const Study &study, const LoadReport &at_rest,
                                                       const Eigen::Vector3d &table_motion,
                                                       const ring::Answer &answer,
                                                       const std::vector<std::pair<double, double>> &torques);

/// Returns the quantities of interest of a study from its @p load, which has a contact, with the torque at
/// @p spins [rad/s]; empty: spins_of_interest(). @p omega_guess: initial guess of the terminal spin. Throws
/// as @p load and ring::terminal_spin(), and ring::NoBalance if the glass tips.
std::vector<QuantityOfInterest> quantities_of_load(const Study &study, const BalancedLoad &load,
                                                   std::vector<double> spins = {},
                                                   const std::optional<double> &omega_guess = {});

/// Returns 0.5 and 1.5 times the terminal spin, where torques are evaluated by default.
std::vector<double> spins_of_interest(double omega_terminal);

/// Returns the quantity @p key. Throws std::out_of_range if there is none.
const QuantityOfInterest &quantity_of(const std::vector<QuantityOfInterest> &quantities,
                                      const std::string &key);

/// Returns the key of a goal; empty for none.
std::string key_of(Goal goal);

/// Returns the quantity @p key; end() if there is none.
ErrorBands::const_iterator find_quantity(const ErrorBands &quantities, const std::string &key);

/// Returns the position of the quantity @p key. Throws std::out_of_range if there is none.
std::size_t index_of(const ErrorBands &quantities, const std::string &key);

/// Returns the half-width of the error band of the quantity @p key; std::nullopt if there is none.
std::optional<double> band_of(const ErrorBands &quantities, const std::string &key);

} // namespace stemware::pipeline
