#pragma once

#include "fem/contact/foot.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Sequence of the contacts of one foot, from which the next contact is predicted. It belongs to the caller;
/// a foot has no memory.
class ContactPath
{
public:
  /// Returns the initial guess of the contact under @p demand at @p slip: `previous` is @p before, or the
  /// last contact if @p before is nullptr. `predicted` is the polynomial in the spin through the nearest
  /// contacts under the same demand or at rest; if fewer than two are near, or if contacts of the similar
  /// foot are much nearer, the prediction from the similar foot; without one, the nearest contact. Only
  /// contacts with the same marks are used.
  fem::ContactGuess guess(const fem::ContactDemand &demand, const ring::Slip &slip,
                          const fem::ContactState *before = nullptr) const;

  /// Returns the contact nearest to @p slip between rest and there, with the same marks, as an initial guess;
  /// std::nullopt if there is none in the first zone.
  std::optional<fem::ContactStart> nearest_towards_rest(const ring::Slip &slip) const;

  /// Appends @p state.
  void append(const fem::ContactState &state);

  /// Adds predictions of the foot @p own from the contacts of @p similar, the path of the foot @p other.
  void predict_from_similar(const ContactPath &similar, const fem::Foot &own, const fem::Foot &other);

private:
  /// Contact with the demand and slip that it was solved for.
  struct Found
  {
    explicit Found(const fem::ContactState &state);

    /// Normal force, moment and tilt moment; without the moment of friction, which depends on the spin.
    Eigen::Vector4d demand;
    ring::Slip slip;
    unsigned int zone; ///< ContactState::zone
    fem::ContactStart start;
  };

  /// Returns the polynomial through the nearest of @p points at @p spin; std::nullopt for fewer than @p
  /// n_least points.
  static std::optional<fem::ContactStart> between(std::vector<const Found *> points, double spin,
                                                  std::size_t n_least);

  /// Returns the start predicted at @p slip from @p own contacts and contacts of the similar foot.
  std::optional<fem::ContactStart> expected(const std::vector<const Found *> &own,
                                            const ring::Slip &slip) const;

  std::optional<fem::ContactState> last;
  std::vector<Found> recent;            ///< oldest first
  std::vector<Found> from_similar_foot; ///< predictions added by predict_from_similar()
};

} // namespace stemware::pipeline
