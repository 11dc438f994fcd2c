#pragma once

#include "fem/pipeline/analysis/spin_row.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// One model of the chain from the paper's to the study's.
struct BudgetRow
{
  std::string step; ///< "1", "2", "2a", "3", "3a", "4", ...
  /// Of the difference to the row above: "" (row 1: "paper"), "moment balance" or "given moment", "grip",
  /// "where the foot touches", "tilt", "harmonics".
  std::string name;
  std::optional<unsigned int> harmonics;                                 ///< kept; none: all
  std::optional<double> omega_terminal = {}, difference = {}, band = {}; ///< [rad/s]
  /// tau_z [N m] at 0, half and all of the complete model's terminal spin.
  std::array<std::optional<double>, 3> torques = {};
  Standing standing = Standing::no_balance;
  std::string reason = {}; ///< why something is missing
};

/// The complete model with one thing left out.
struct WithoutRow
{
  std::string name;                                           ///< "tilt", ...
  std::optional<double> omega_terminal = {}, difference = {}; ///< to the complete model [rad/s]
  std::string reason = {};                                    ///< why there is none: "not defined", ...
};

/// Row `all` against row 3a (3 where the tilt is off).
struct HarmonicEffect
{
  std::optional<double> absolute = {}; ///< [rad/s]
  std::optional<double> relative = {};
};

/// What each step from the paper's model to the study's does to the terminal spin.
struct Budget
{
  std::vector<BudgetRow> rows;
  std::vector<WithoutRow> without;
  HarmonicEffect harmonics;
  std::vector<double> omega, torque_all, torque_first; ///< [rad/s], [N m]
};

} // namespace stemware::pipeline
