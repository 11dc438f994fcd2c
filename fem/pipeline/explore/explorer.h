#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/explore/live_path.h"
#include "fem/revolution/contact_compliance.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Match of the mesh of an Explorer's compliances with a study.
enum class MeshMatch
{
  same,  ///< `stemware run` would make the same mesh
  close, ///< it would make one of other cells; the answer has a band
  none   ///< the contact would not be resolved
};

/// Bound on the difference of a spin under MeshMatch::close to the one that `stemware run` finds on its own
/// mesh [rad/s], four times what contacts of other widths differ by (tests: Live).
constexpr double close_mesh_band = 2e-5;

/// The answer to a study as a page shows it.
struct LiveAnswer
{
  MeshMatch match = MeshMatch::same;
  ring::Answer all;                    ///< all harmonics
  std::optional<ring::Answer> first_n; ///< the first n alone, where so few were asked
  ring::Answer paper;                  ///< the paper's rigid ring
  /// The contact where the spin-up ends, or at rest where there is no spin; nothing without one.
  std::optional<fem::ContactState> contact;
  double contact_radius = 0; ///< [m]
};

/// Curves of a LiveAnswer; NaN where there is no balance.
struct LiveCurves
{
  TorqueCurve torque;             ///< of all harmonics, and of the first n
  std::vector<double> of_paper;   ///< tau_z of the paper's ring at the same spins [N m]
  std::vector<double> time;       ///< [s]
  std::vector<double> spin;       ///< omega(t), all harmonics [rad/s]
  std::vector<double> spin_n;     ///< the first n alone; empty where all were asked [rad/s]
  std::vector<double> spin_paper; ///< of the paper's ring [rad/s]
};

/// Study for interactive use, changed and solved repeatedly on compliances that are given: no mesh
/// is made. What the mesh would have to follow is refused.
class Explorer
{
public:
  /// The foot alone, with its Young modulus as the study has it now, or the disc under it.
  void take(std::shared_ptr<const fem::ContactCompliance> compliance, bool is_disc);

  /// Gives an entry of the study another value; throws BadInput for entries and values that there are not,
  /// and, once ready(), for entries that the compliances depend on.
  void set(const std::string &path, const std::string &value);

  /// The study with its values so far is the one that the compliances were made for, on a mesh of @p fineness
  /// (ContactSection::fineness).
  void ready(double fineness);

  const Study &study() const { return present; }
  /// Returns the match of the mesh with the present study.
  MeshMatch mesh_match() const;

  /// Solves the study with @p n_harmonics, from the last answer to 1e-7 rad/s, where that leads on without
  /// its state at rest, or, where @p cold, as `stemware run` does. Throws BadInput with one sentence for what
  /// is refused, and what contacts and balances throw at rest.
  LiveAnswer solve(unsigned int n_harmonics, bool cold);

  /// Curves of the last answer; nothing where it has no spin.
  std::optional<LiveCurves> curves();

  /// The chain of models from the paper's to the last answer's.
  std::vector<BudgetRow> budget();

  /// The pressure of @p contact, that of the last answer.
  fem::PressureMap pressure(const fem::ContactState &contact) const
  {
    return foot->body().pressure_map(contact);
  }

private:
  std::shared_ptr<fem::Foot> make_foot(const Study &study) const;
  Executor executor() const;
  /// Fills in the rows of @p answer by balances next to those before, on the rings of @p last; whether that
  /// leads on. Then there is no curve and no budget.
  bool follow(const ElasticFoot &last, unsigned int n_harmonics, LiveAnswer &answer);
  /// The same from what the contacts of @p last let expect, if any, else from nothing.
  void solve_cold(const ElasticFoot *last, unsigned int n_harmonics, LiveAnswer &answer);

  Study present, base;
  bool is_ready = false;
  std::shared_ptr<const fem::ContactCompliance> compliance, disc_compliance;
  std::shared_ptr<ElasticFoot> foot; ///< of the last answer
  std::vector<LoadedRow> rows;       ///< of the last answer, that of all harmonics last; none of follow()
  LivePath path;
  /// The terminal spin of the first n harmonics alone less that of all in the last answer [rad/s].
  double shift_of_first_n = 0;
};

/// A compliance as numbers in a row, and back: nodes, degree, highest harmonic, unknowns, whether the land
/// goes on inside and outside, the radii, then of each harmonic, and of those beyond, the lower triangle of
/// `normal` by columns, `radial` and `azimuthal`.
std::vector<double> serialized(const fem::ContactCompliance &compliance);
fem::ContactCompliance deserialized(const double *numbers);

} // namespace stemware::pipeline
