#pragma once

#include "fem/contact/foot.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Solved contacts of one foot, from which the next contact is predicted.
class ContactPath
{
public:
  /// Returns the initial guess of the contact under @p demand at @p slip, from contacts with the same
  /// orientation of glass and table. `previous`: @p before, or the last contact if nullptr. `predicted`: the
  /// polynomial in the spin through the nearest contacts under the same demand or at rest. If fewer than two
  /// exist, or if contacts of the similar foot are much nearer, the polynomial passes through the contacts of
  /// the similar foot. If it has none, `predicted` is the nearest contact.
  fem::ContactGuess guess(const fem::ContactDemand &demand, const ring::Slip &slip,
                          const fem::ContactState *before = nullptr) const;

  /// Returns the contact at the spin nearest to @p slip, between rest and @p slip, if any. It must have the
  /// same orientation of glass and table, and zone 0.
  std::optional<fem::ContactStart> nearest_towards_rest(const ring::Slip &slip) const;

  /// Appends a solved contact.
  void append(const fem::ContactState &state);

  /// Adds predictions for the foot @p own from the contacts in @p similar, the path of the foot @p other.
  void predict_from_similar(const ContactPath &similar, const fem::Foot &own, const fem::Foot &other);

private:
  /// Contact with its demand and slip.
  struct Found
  {
    explicit Found(const fem::ContactState &state);

    /// Normal force, moment and tilt moment; not the moment of friction, which depends on the spin.
    Eigen::Vector4d demand;
    ring::Slip slip;
    unsigned int zone; ///< ContactState::zone
    fem::ContactStart start;
  };

  /// Returns the polynomial through the nearest of @p points at @p spin, if @p n_least or more can be used.
  static std::optional<fem::ContactStart> between(std::vector<const Found *> points, double spin,
                                                  std::size_t n_least);

  /// Returns the start predicted at @p slip from @p own contacts or from contacts of the similar foot.
  std::optional<fem::ContactStart> expected(const std::vector<const Found *> &own,
                                            const ring::Slip &slip) const;

  std::optional<fem::ContactState> last;
  std::vector<Found> recent;            ///< oldest first
  std::vector<Found> from_similar_foot; ///< predictions added by predict_from_similar()
};

} // namespace stemware::pipeline
