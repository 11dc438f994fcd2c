#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
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
  same,  ///< `stemware run` generates the same mesh
  close, ///< `stemware run` generates another mesh; the answer has a band
  none   ///< the mesh does not resolve the contact
};

/// Bound on the error of a spin under MeshMatch::close [rad/s], relative to `stemware run` on its own mesh:
/// four times the differences observed between contacts of different widths (tests: Live).
constexpr double close_mesh_band = 2e-5;

/// Answer to a study for the live page.
struct LiveAnswer
{
  MeshMatch match = MeshMatch::same;
  ring::Answer full;                     ///< all harmonics
  std::optional<ring::Answer> truncated; ///< the first n harmonics only, if n is given
  ring::Answer paper;                    ///< the paper's rigid ring
  /// Contact at the end of the spin-up, or at rest without a spin; std::nullopt without a contact.
  std::optional<fem::ContactState> contact;
  double contact_radius = 0; ///< [m]
};

/// Study for interactive use, changed and solved repeatedly with given compliances and without meshes.
/// Changes that need another mesh are rejected.
class Explorer
{
public:
  /// Sets the compliance of the foot, for the study's present Young modulus, or of the disc.
  void set_compliance(std::shared_ptr<const fem::ContactCompliance> compliance, bool is_disc);

  /// Sets an entry of the study. Throws BadInput for unknown entries, inadmissible values, and, after
  /// freeze_mesh(), for entries on which the compliances depend. Another contact radius selects a similar
  /// foot: all lengths of the glass except the crown radius are scaled; an elastic table needs the disc of
  /// this radius.
  void set(const std::string &path, const std::string &value);

  /// Declares that the compliances belong to the present study and to a mesh of @p fineness
  /// (Discretisation::fineness).
  void freeze_mesh(double fineness);

  const Study &study() const { return present; }
  /// Returns the match of the mesh with the present study.
  MeshMatch mesh_match() const;

  /// Solves the study with @p n_harmonics: from the last answer, to 1e-7 rad/s and without the state at rest,
  /// if that converges; from a cold start like `stemware run` if @p cold. Throws BadInput for a rejected
  /// study, and as contact solves and balances at rest.
  LiveAnswer solve(unsigned int n_harmonics, bool cold);

  /// Returns the curves of the last answer; std::nullopt without a spin.
  std::optional<StudyCurves> curves();

  /// Returns the chain of models from the paper's model to the last answer's, and the effect of the
  /// harmonics.
  Budget budget();

  /// Returns the pressure of @p contact, the contact of the last answer.
  fem::PressureMap pressure(const fem::ContactState &contact) const
  {
    return foot->body().pressure_map(contact);
  }

private:
  std::shared_ptr<fem::Foot> make_foot(const Study &study, const Discretisation &discretisation,
                                       const Model &model) const;
  Executor executor() const;
  void require_mesh() const;
  /// Returns the size of the foot relative to the foot of the compliances.
  double size() const { return present.glass.profile.contact_radius / base.glass.profile.contact_radius; }
  /// Solves @p answer from the previous balance on the rings of @p last. Returns true if the solve converged.
  /// Computes no curves and no budget.
  bool follow(const ElasticFoot &last, unsigned int n_harmonics, LiveAnswer &answer);
  /// Solves @p answer from the predictions of the contacts of @p last, or from a cold start if nullptr.
  void solve_cold(const ElasticFoot *last, unsigned int n_harmonics, LiveAnswer &answer);

  Study present, base;
  Discretisation discretisation; ///< discretisation of the compliances
  bool is_ready = false;
  std::shared_ptr<const fem::ContactCompliance> compliance, disc_compliance;
  std::shared_ptr<ElasticFoot> foot; ///< foot of the last answer
  LoadedRow paper;                   ///< the paper's row of the last answer
  std::vector<LoadedRow> rows;       ///< rows of the last answer, all harmonics last; empty after follow()
  /// Terminal spin and contact of all harmonics of the last answer: the next initial guess.
  std::optional<ring::ZeroGuess> zero;
  std::optional<fem::ContactState> contact_at_zero;
  /// Terminal spin of the first n harmonics minus terminal spin of all, in the last answer [rad/s].
  double shift_of_truncated = 0;
};

/// Converts a compliance to a list of numbers and back: nodes, degree, highest harmonic, unknowns, whether
/// the land continues inside and outside, radii, then for each harmonic and the tail the lower triangle of
/// `normal` by columns, `radial` and `azimuthal`.
std::vector<double> serialized(const fem::ContactCompliance &compliance);
fem::ContactCompliance deserialized(const double *numbers);

} // namespace stemware::pipeline
