#pragma once

#include "fem/contact/foot.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The contacts of one foot as they follow each other, from which the next one is expected. It belongs to
/// whoever asks for them: a foot itself remembers nothing.
class ContactPath
{
public:
  /// Returns the initial guess of the contact under @p demand at @p slip: @p before, or the last contact if
  /// @p before is nullptr. What is expected is the polynomial in the spin through the nearest contacts under
  /// the same demand or at rest; where fewer than two are near enough, or those of the similar foot are much
  /// nearer, that of the similar foot; without one, the nearest contact. Only contacts with the same marks
  /// count.
  fem::ContactGuess guess(const fem::ContactDemand &demand, const ring::Slip &slip,
                          const fem::ContactState *before = nullptr) const;

  /// Goes on to @p state.
  void append(const fem::ContactState &state);

  /// Expects of @p own what the contacts of @p similar, a path of the foot @p other, tell of it.
  void predict_from_similar(const ContactPath &similar, const fem::Foot &own, const fem::Foot &other);

private:
  /// A contact, and what it was found for.
  struct Found
  {
    explicit Found(const fem::ContactState &state);

    /// Normal force, moment and tilt moment; the friction's moment depends on the spin and is left out.
    Eigen::Vector4d demand;
    ring::Slip slip;
    unsigned int zone; ///< ContactState::zone
    fem::ContactStart start;
  };

  /// The polynomial through those of @p points that are nearest to @p spin, at least @p n_least of them.
  static std::optional<fem::ContactStart> between(std::vector<const Found *> points, double spin,
                                                  std::size_t n_least);

  /// Start at @p slip that @p own contacts and those of the similar foot let expect.
  std::optional<fem::ContactStart> expected(const std::vector<const Found *> &own,
                                            const ring::Slip &slip) const;

  std::optional<fem::ContactState> last;
  std::vector<Found> recent;            ///< oldest first
  std::vector<Found> from_similar_foot; ///< those of predict_from_similar()
};

} // namespace stemware::pipeline
