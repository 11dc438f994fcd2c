#pragma once

#include "fem/contact/load_harmonics.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The load on the ring at the spin omega [rad/s]; constant for a frozen load.
using LoadAtSpin = std::function<ring::RingStack(double omega)>;

/// How a load in balance with friction at every spin has been found, so far.
struct CouplingFigures
{
  std::size_t n_balances = 0;                ///< spins at which contact and friction are in balance
  std::size_t n_contact_solutions = 0;       ///< that those took
  std::optional<double> response_error;      ///< of a curve over the moment ratio, see FootResponseCurve
  std::optional<double> interpolation_error; ///< of loads interpolated in the spin, see for_many_spins()
};

/// lambda(theta) as it is handed to the ring, wherever it comes from, with the figures that summary.json
/// reports about it.
struct RingLoad
{
  LoadAtSpin at_spin;                               ///< constant unless the load is in balance at every spin
  ring::RingStack at_rest;                        ///< at_spin(0)
  double normal_force = 0;                          ///< N [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< M_N [N m] at rest
  double moment_ratio = 0;                          ///< |M_N| / (N R / 2) at rest, R the contact radius
  double mean_radius = 0;                           ///< sum f r / sum f [m]
  double contact_fraction = 0;                      ///< share of azimuths that carry load
  double minimum = 0;                               ///< smallest pointwise load [N/rad]
  std::vector<fem::AzimuthLoad>
    pointwise = {}; ///< lambda itself at rest by azimuth; empty unless from a contact
  std::shared_ptr<CouplingFigures> coupling = {}; ///< nothing where the load is the same at every spin
  bool is_costly = false;                         ///< whether at_spin solves contacts
};

/// The load of a contact solution, frozen.
RingLoad frozen_contact_load(const fem::LoadHarmonics &load, double contact_radius);

/// The paper's ansatz on a ring of the contact radius: in balance with the closure at every spin, or with the
/// given moment ratio.
RingLoad first_harmonic_load(const Study &study);

/// The load of Load/File, frozen. Throws BadInput when the file cannot be used, or its load would tip the
/// ring.
RingLoad load_from_file(const Study &study);

} // namespace stemware::pipeline
