#pragma once

#include "fem/pipeline/coupling/leaning_load.h"
#include "fem/pipeline/coupling/phase_grids.h"
#include "fem/pipeline/coupling/spin_interval.h"

#include <Eigen/Core>

#include <exception>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// The load at a spin [rad/s] with the marks at a phase; each is a contact solution, or several.
using LoadAtPhase = std::function<LeaningLoad(double omega, const ring::Orientation &phase)>;

/// How far apart two loads are as friction sees them: the largest difference of tau_z over mu N R among the
/// slip ratios 0, +-1/4 ... +-1, R the ring radius of @p other. Harmonics count as much as they turn the
/// glass: those of a load that is gathered at crests reach far up, where the kernels have vanished.
double torque_difference(const LeaningLoad &one, const LeaningLoad &other);

/// Grids of as many phases as it takes until the interpolant meets @p load at rest to a torque_difference()
/// of 1e-7, to 1e-5 from 32 phases on, at most 128 in each angle and @p most_samples together, with turning
/// samples or not, whichever is better. The error is that of half and of a quarter of the phases, measured at
/// the others and extrapolated, or what three phases off the grid show, if that is more. Below 3e-2 it ends,
/// too, where twice the phases have not halved it: what is left is due to the azimuth lines. That of the mean
/// is what half of the phases, of either angle, change in it. Throws std::runtime_error, with a sentence,
/// where the error stays above 0.3 or that of the mean above 3e-2.
PhaseGrids find_phases(const LoadAtPhase &load, const PhasePeriods &periods, unsigned int most_samples);

/// How a load is sampled that depends on the spin.
struct SpinSampling
{
  double unit = 0; ///< length of the intervals of spins, which begin at 0 [rad/s]; 0: no dependence
  double enough =
    1e-5; ///< error of what the spin adds, torque_difference(), that half of the phases may leave
  unsigned int most_steps = 16; ///< on an interval, a power of two
};

/// The worst of all sampled phases, at rest.
struct PhaseExtremes
{
  double least_load = 0;             ///< pointwise [N/rad]
  double least_contact_fraction = 0; ///< share of the rim that carries load
};

/// A load that depends on where the marks of glass and table stand, and maybe on the spin: sampled on a grid
/// of phases and, interval by interval as spins are asked for, on Chebyshev points; interpolated in between,
/// trigonometrically in the phases and by polynomials in the spin. What the spin adds to the load of rest is
/// sampled at half the phases, unless others show that all are needed.
///
/// A load that rests on w crests turns with them: its harmonic n goes round with the angle phi like exp(i k w
/// phi), k the integer next to n / w. That factor is taken out of the samples, and what is left depends on
/// phi smoothly even where the load is gathered at the crests.
class PhaseLoads
{
public:
  /// @p load is kept.
  PhaseLoads(LoadAtPhase load, const PhaseGrids &grids, const SpinSampling &spins = {},
             const PhaseExtremes &extremes = {});

  /// Throws std::runtime_error, as find_phases(), where the samples round @p omega leave as large an error.
  LeaningLoad at(double omega, const ring::Orientation &phase) const;

  /// Mean over all phases. It carries the mean moment.
  LeaningLoad mean(double omega) const;

  /// The loads at all sampled phases.
  std::vector<ring::RingStack> samples(double omega) const;
  const PhaseGrids &phases() const { return grids; }

  std::size_t n_spins() const; ///< sampled so far; 1 where the load does not depend on the spin
  /// Largest torque_difference() from the load found halfway between samples.
  double error() const { return largest_error; }
  /// Error of mean(): what half of the phases say otherwise, at rest and of what the spin adds, and what
  /// interpolation between spins leaves, at one phase or, if that is less, what half of the spins say
  /// otherwise.
  double mean_error() const { return largest_mean_error; }
  const PhasePeriods &periods() const { return grids.periods; }
  const PhaseExtremes &at_rest_extremes() const { return extremes; }

private:
  /// Samples on one interval of spins: per spin a matrix with a column per phase, LeaningLoad::coefficients()
  /// without what turns.
  struct Samples
  {
    SpinInterval spins;
    std::vector<Eigen::MatrixXd> columns;
  };

  LeaningLoad load_of(const Eigen::VectorXd &column) const;
  Eigen::Index n_harmonics(Eigen::Index n_rows) const;
  /// k above.
  unsigned int crest_harmonic(Eigen::Index n) const;
  /// Multiplies the load harmonics of @p column with exp(i k w angle).
  void turn(Eigen::VectorXd &column, double angle) const;
  /// Per spin a column per phase of @p on.
  std::vector<Eigen::MatrixXd> sample(const std::vector<double> &omegas, const PhaseGrids &on) const;
  /// Spins of an interval, as many as it takes, and the error between them, torque_difference(); where the
  /// load has kinks in the spin, as many as it takes below 3e-2 until twice as many leave over a third of it.
  std::pair<SpinInterval, double> find_spins(long interval) const;
  const Samples &samples_around(double omega) const;
  Samples samples_of(long interval) const;
  /// Largest torque_difference() of @p samples from the load at phases that half the grid leaves out.
  double error_of(const Samples &samples) const;
  /// Largest torque_difference() of mean() at every other spin of @p samples from what the others say.
  double error_of_halved_spins(const Samples &samples) const;
  /// Samples of the spins on the phases @p on, brought to all phases: what the spin adds is interpolated.
  std::vector<Eigen::MatrixXd> spread(const std::vector<double> &omegas, const PhaseGrids &on) const;
  /// A column per phase, without what turns.
  Eigen::MatrixXd at_spin(double omega) const;
  Eigen::MatrixXd in_slip_frame(Eigen::MatrixXd columns) const;
  LeaningLoad mean_of(const Eigen::MatrixXd &columns) const;

  const LoadAtPhase load;
  const PhaseGrids grids;
  const SpinSampling spins_asked;
  const PhaseExtremes extremes;
  mutable std::size_t n_rings = 1; ///< of every sample
  const Eigen::MatrixXd at_rest;
  mutable std::map<long, Samples> intervals;
  mutable std::map<long, std::exception_ptr> failures; ///< of other intervals
  mutable double largest_error, largest_mean_error;
};

} // namespace stemware::pipeline
