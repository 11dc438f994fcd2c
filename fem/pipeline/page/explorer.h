#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/revolution/contact_compliance.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Error bound of a spin if LiveAnswer::mesh_differs, relative to `stemware run` [rad/s]: four times the
/// differences between contacts of different widths (tests: Live).
constexpr double close_mesh_band = 2e-5;

/// Answer to a study for the live page.
struct LiveAnswer
{
  /// True if `stemware run` generates another mesh than the mesh of the compliances; the answer then has a
  /// band.
  bool mesh_differs = false;
  ring::Answer full;                      ///< all harmonics
  std::optional<ring::Answer> truncated;  ///< first n harmonics only, if n is given
  ring::Answer paper;                     ///< the paper's model
  fem::ContactState contact;              ///< at the end of the spin-up, or at rest without a spin
  LoadReport load;                        ///< load of `contact`
  std::optional<LoadReport> load_at_rest; ///< std::nullopt if the state at rest is not computed
};

/// Study that is changed and solved repeatedly with given compliances; rejects changes that need a new mesh.
class Explorer
{
public:
  /// Sets the compliance of the foot, for the study's present Young modulus, or of the disc. @p numbers: as
  /// serialized() returns.
  void set_compliance(const double *numbers, bool is_disc);

  /// Sets an entry of the study. Throws BadInput for unknown entries, inadmissible values, and, after
  /// freeze_mesh(), for entries that change the compliances. Another contact radius then scales all lengths
  /// of the glass but the crown radius (a similar foot); an elastic table needs the disc of this radius.
  void set(const std::string &path, const std::string &value);

  /// Declares that the compliances are those of the present study, on a mesh of Discretisation::fineness.
  void freeze_mesh(double fineness);

  const Study &study() const { return present; }

  /// Solves the study with all and with the first @p n_harmonics harmonics. If @p cold, solves it like
  /// `stemware run`. Otherwise starts from the last answer: if the solve converges, the spin is accurate to
  /// 1e-7 rad/s, and the state at rest is not computed. Throws BadInput for a rejected study, and as contact
  /// solves and balances at rest.
  LiveAnswer solve(unsigned int n_harmonics, bool cold);

  /// Returns the curves of the last answer, up to Motion/End time of the present study; std::nullopt without
  /// a spin or after a warm start.
  std::optional<StudyCurves> curves();

  /// Returns the answers by harmonics and of the models from the paper's to the last answer's; std::nullopt
  /// after a warm start.
  std::optional<StudyRows> models();

  /// Returns LiveAnswer::contact of the last answer.
  const std::optional<fem::ContactState> &contact() const { return contact_at_zero; }
  /// Returns the pressure of contact().
  fem::PressureMap pressure() const { return foot->body().pressure_map(*contact_at_zero); }

private:
  /// Returns LiveAnswer::mesh_differs of the present study. Throws BadInput if the mesh of the compliances
  /// does not resolve the contact.
  bool mesh_differs() const;
  std::shared_ptr<fem::Foot> make_foot(const FootSpecification &specification) const;
  Executor executor() const;
  /// Returns the size of the foot over that of the foot of the compliances.
  double size() const { return present.glass.profile.contact_radius / base.glass.profile.contact_radius; }
  /// Solves @p answer from the previous balance on the rings of @p last. Returns true if the solve converged.
  bool follow(const ElasticFoot &last, unsigned int n_harmonics, LiveAnswer &answer);
  /// Solves @p answer with predictions from the contacts of @p last; nullptr: from a cold start.
  void solve_cold(const ElasticFoot *last, unsigned int n_harmonics, LiveAnswer &answer);

  Study present, base;
  Discretisation discretisation; ///< discretisation of the compliances
  bool is_ready = false;
  fem::ContactCompliance compliance, disc_compliance;
  std::shared_ptr<ElasticFoot> foot; ///< foot of the last answer
  LoadedRow paper;                   ///< the paper's row of the last answer
  std::vector<LoadedRow> rows;       ///< of the last answer, all harmonics last; empty after follow()
  /// Terminal spin and contact of the last answer with all harmonics: the next initial guess.
  std::optional<ring::TerminalSpin> zero;
  std::optional<fem::ContactState> contact_at_zero;
  /// Terminal spin of the first n harmonics minus spin of all, in the last answer [rad/s].
  double shift_of_truncated = 0;
};

/// Converts a compliance to numbers: nodes, degree, highest harmonic, unknowns, n_inside, n_outside, radii;
/// for each harmonic and the tail the lower triangle of `normal` by columns, `radial` and `azimuthal`.
std::vector<double> serialized(const fem::ContactCompliance &compliance);

} // namespace stemware::pipeline
