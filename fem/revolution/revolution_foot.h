#pragma once

#include "fem/contact/foot.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/revolution_contact.h"
#include "fem/revolution/revolution_setup.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// The foot as a body of revolution on its table, known by its compliance alone, whose contacts
/// RevolutionContact finds. Solving is not collective.
class RevolutionFoot : public Foot
{
public:
  /// With @p compliance of the foot and substrate of @p setup, of the whole land, or of a part of it: then a
  /// contact that leaves the part is refused, std::out_of_range. Throws std::invalid_argument for a setup
  /// that is not allowed.
  RevolutionFoot(const RevolutionSetup &setup, std::shared_ptr<const ContactCompliance> compliance);

  /// The same foot with a state of its own.
  RevolutionFoot(const RevolutionFoot &other);

  std::shared_ptr<const Foot> twin() const override;
  FootDescription description() const override;
  FootCapabilities capabilities() const override;
  ContactState solve(const ContactDemand &demand, const ring::Slip &slip = {}, const ContactGuess &guess = {},
                     const std::function<void(const ContactIteration &)> &progress = {}) const override;
  /// Where neither is out of flat and both bodies and hardness are the same; others have nothing to tell.
  std::optional<ContactStart> expected_from(const ContactStart &start, unsigned int zone,
                                            const Foot &similar) const override;
  unsigned int n_resolved_harmonics() const override;
  ContactLoad gather(const ContactState &state, const std::vector<double> &ring_radii,
                     unsigned int n_harmonics) const override;
  std::vector<PointForce> point_forces(const ContactState &state) const override;
  PressureMap pressure_map(const ContactState &state) const override;

  /// The body that is loaded about the contact radius.
  const BodyOfRevolution &elastic_body() const { return zones.front()->body; }

protected:
  /// A part of the land with the body that is loaded there alone: what a contact is worked out on.
  struct Zone
  {
    Zone(const RevolutionFoot &foot, ContactCompliance compliance);

    BodyOfRevolution body;
    const std::shared_ptr<TableLaw> law; ///< has no state; copies share it
    ring::Orientation marks;             ///< that the gaps stand at
  };

  /// The zone of @p state with its body as the state has it.
  Zone &zone_of(const ContactState &state) const;
  BodyOfRevolution::Gap gap_at(const ring::Orientation &marks) const;
  SlidingTraction sliding_at(const ring::Slip &slip) const;
  /// Azimuth of the first line [rad]: crest() less whole lines, at most half a line from that of travel.
  double axis(const ring::Orientation &marks) const;

  const RevolutionSetup setup;
  const std::shared_ptr<const ContactCompliance> compliance; ///< of the land, or of a part of it
  const std::shared_ptr<const InterfaceLaw> interface;       ///< a hard one as a stiff spring

private:
  /// The compliance of the whole land, for contacts that leave the part. Throws std::out_of_range where it is
  /// not known.
  virtual std::shared_ptr<const ContactCompliance> of_whole_land() const;
  /// The zone with its gaps at @p marks; the body's state is anything.
  Zone &zone_at(unsigned int zone, const ring::Orientation &marks) const;
  /// Whether the contact on @p zone has come to a border of it that is none of the land.
  bool has_left(const Zone &zone) const;
  /// Solves the contact of @p state on its zone, in the axes of the lines.
  void press(const ContactGuess &guess, ContactState &state) const;
  /// @p guess in the axes of the lines, with the marks at @p marks. The contact before presses in as far as
  /// it did, where it was and, if the crests have moved on by lines, turned with them; first comes what was
  /// right the last time.
  RevolutionStarts starts_from(const ContactGuess &guess, const ring::Orientation &marks) const;

  /// Nodal values turned counter-clockwise by @p n lines.
  Eigen::VectorXd turned_by_lines(const Eigen::VectorXd &nodal, long n) const;
  double line_spacing() const; ///< [rad]
  /// Azimuth of the crests, of the rim's waviness, else of the table's; 0 where there is none [rad].
  double crest(const ring::Orientation &marks) const;
  /// The line that the crests are next to. The lines go with the crests: else a narrow contact at a crest,
  /// between lines at one phase and on a line at the next, would not depend smoothly on the phase. Whole
  /// lines are no change.
  long crest_line(const ring::Orientation &marks) const;
  /// A band about the contact radius, and the whole land for contacts that leave it, made when one does.
  mutable std::array<std::unique_ptr<Zone>, 2> zones;
};

} // namespace stemware::fem
