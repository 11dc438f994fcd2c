#pragma once

#include "fem/pipeline/analysis/fit_parameters.h"
#include "fem/pipeline/analysis/spin_up.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/variants/executor.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Interpolation of vectors in several variables: exact at the centre, through the other points the
/// polynomial of least degree, so that few points serve.
class ScatteredPolynomial
{
public:
  /// Sets the value at @p place, which becomes the centre if @p is_centre. Points that are nearer to the
  /// centre than 0.003 are left out.
  void add(const Eigen::VectorXd &place, const Eigen::VectorXd &value, bool is_centre);

  bool empty() const { return points.empty(); }
  const Eigen::VectorXd &centre() const { return points.front().place; }
  Eigen::VectorXd at(const Eigen::VectorXd &place) const;

private:
  struct Point
  {
    Eigen::VectorXd place, value;
  };
  /// Monomials of a distance from the centre, the less the higher their degree.
  Eigen::VectorXd monomials(const Eigen::VectorXd &from_centre) const;

  std::vector<Point> points;    ///< the centre first
  double reach = 1;             ///< of the points
  Eigen::MatrixXd coefficients; ///< of the monomials. Shape [value, monomial]; empty with one point.
};

/// Spin-ups of one study for values of the free entries.
///
/// A load from a contact is solved at few values of the entries only. Between them the torque over the spin
/// is interpolated: the difference to the torque of the paper's first harmonic in closed form, over mu N R,
/// as a function of the entries and of the spin as a share of a last spin, which is in proportion to that of
/// the first harmonic. solve_at() adds a solved load. Loads without such an interpolation are solved: those
/// at values of the entries for which the first harmonic has no last spin, and all of them once a load of
/// solve_at() has no balance at one of its spins.
class SpinUps
{
public:
  SpinUps(const Study &study, const std::vector<FitParameter> &parameters, const Executor &executor)
      : study(study)
      , parameters(parameters)
      , executor(executor)
      , moved_study(study, parameters)
  {
  }

  /// Returns the spin-up for unknowns @p x of the parameters. Throws what find_load() and ring::answer()
  /// throw.
  const SpinUp &at(const Eigen::VectorXd &x);

  /// Returns the derivative of the spin-up at @p x by unknown @p j. Exact for grip and inertia; for an entry
  /// of the load, as good as the difference of the torques at two values of the entry.
  const SpinCourse &derivative(const Eigen::VectorXd &x, Eigen::Index j);

  /// Solves the load at @p x, if loads are interpolated, and interpolates through it from then on: exactly at
  /// @p x until another load is a centre.
  void solve_at(const Eigen::VectorXd &x, bool is_centre = true);

  bool interpolates() const { return is_interpolated; }
  /// Returns the unknowns of the load at the centre.
  const Eigen::VectorXd &centre() const { return beyond_first_harmonic.centre(); }
  /// Returns the change of the spin-up at @p x by a constant torque: the bound on what the torque at the
  /// centre misses between the spins of the contacts.
  SpinCourse missed(const Eigen::VectorXd &x);
  /// Number of contacts solved so far.
  std::size_t n_contacts() const { return foot ? foot->n_contacts() : 0; }

private:
  /// Torque of the paper's first harmonic, and the scales that are those of the interpolation too.
  struct FirstHarmonic
  {
    double last;             ///< [rad/s]
    double unit;             ///< mu N R [N m]
    Eigen::VectorXd torques; ///< at the shares of the last spin [N m]
  };
  FirstHarmonic first_harmonic(const Study &now) const;

  /// The unknowns on which the load depends.
  Eigen::VectorXd place_of(const Eigen::VectorXd &x) const;
  const TorqueBySpin &torque_at(const Study &now, const Eigen::VectorXd &place);
  /// std::nullopt if the first harmonic has no last spin, or if the torque does not slow the glass there.
  std::optional<TorqueBySpin> interpolated_torque(const Study &now, const Eigen::VectorXd &place) const;
  /// Returns the torque of the load of @p now, solved.
  TorqueBySpin solved_torque(const Study &now);
  /// Solves the first load of the interpolation.
  void begin(const Study &now, const Eigen::VectorXd &place);
  /// Interpolates through the torques of @p load, the solved load of @p now, from now on. Spins are added
  /// until the last one misses by less than 1e-7 of mu N R.
  void add_solved(const Study &now, const Eigen::VectorXd &place, const ring::LoadAtSpin &load,
                  bool is_centre);
  SharedLoad load_of(const Study &now);
  /// Ends the interpolation: every load is solved afterwards.
  void interpolate_no_more();
  void forget_curves();
  SpinCourse find_derivative(const Eigen::VectorXd &x, Eigen::Index j);

  const Study study;
  const std::vector<FitParameter> &parameters;
  const Executor &executor;
  MovedStudy moved_study;
  std::shared_ptr<ElasticFoot> foot; ///< of the last load
  bool is_interpolated = study.load.is_from_contact();
  ScatteredPolynomial beyond_first_harmonic; ///< at TorqueBySpin::shares(), over mu N R
  double stretch = 1;                        ///< last spin over that of the first harmonic
  double error = 0; ///< of the torques of the centre between the solved spins, over mu N R
  std::map<std::vector<double>, TorqueBySpin> torques;
  std::map<std::vector<double>, SpinUp> spin_ups;
  std::map<std::pair<std::vector<double>, Eigen::Index>, SpinCourse> derivatives;
};

} // namespace stemware::pipeline
