#pragma once

#include "fem/contact/foot.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/revolution_contact.h"
#include "fem/revolution/revolution_setup.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Foot as a body of revolution, defined by its compliance; solved by solve_revolution_contact(). Not
/// collective.
///
///     RevolutionSetup setup;                                       // glass, table and resolution
///     setup.table.interface = std::make_shared<RoughInterface>();
///     const MeshedRevolutionFoot foot(setup.resolved_for(weight)); // computes the compliances
///     foot.solve({ weight, 0, -moment }).load.b(1);                // N, M_Nx, M_Ny; [N/rad]
class RevolutionFoot : public Foot
{
public:
  /// Creates a foot with the total @p compliance of @p setup on the whole land, or on a part of it beyond
  /// which contacts throw std::out_of_range. Throws std::invalid_argument for an inadmissible setup.
  RevolutionFoot(const RevolutionSetup &setup, std::shared_ptr<const ContactCompliance> compliance);

  /// Copies the foot with its own state.
  RevolutionFoot(const RevolutionFoot &other);

  std::shared_ptr<const Foot> clone() const override;
  FootDescription description() const override;
  FootCapabilities capabilities() const override;
  ContactState solve(const ContactDemand &demand, const ring::Slip &slip = {}, const ContactGuess &guess = {},
                     const std::function<void(const ContactIteration &)> &progress = {}) const override;
  /// Returns std::nullopt unless both feet are without waviness and have equal bodies and hardness.
  std::optional<ContactStart> predict_from(const ContactStart &start, unsigned int zone,
                                           const Foot &similar) const override;
  unsigned int n_resolved_harmonics() const override;
  ContactLoad project_onto_rings(const ContactState &state, const std::vector<double> &ring_radii,
                                 unsigned int n_harmonics) const override;
  std::vector<PointForce> point_forces(const ContactState &state) const override;
  PressureMap pressure_map(const ContactState &state) const override;

  /// Returns the body that is loaded about the contact radius.
  const BodyOfRevolution &elastic_body() const { return zones.front()->body; }

protected:
  /// Part of the land with the body restricted to forces on this part.
  struct Zone
  {
    Zone(const RevolutionFoot &foot, ContactCompliance compliance);

    /// Returns the first and the last circle with forces above rounding.
    std::pair<Eigen::Index, Eigen::Index> loaded_circles() const;

    BodyOfRevolution body;
    const std::shared_ptr<TableLaw> law; ///< has no state; copies share it
    ring::Orientation marks;             ///< orientation for which the gaps are set
  };

  /// Returns the zone of @p state with its body in that state.
  Zone &zone_of(const ContactState &state) const;
  BodyOfRevolution::Gap gap_at(const ring::Orientation &marks) const;
  SlidingTraction sliding_at(const ring::Slip &slip) const;
  /// Returns the azimuth of the first line [rad]: crest() minus whole spacings, within half a spacing of 0.
  double axis(const ring::Orientation &marks) const;

  const RevolutionSetup setup;
  const std::shared_ptr<const ContactCompliance> compliance; ///< compliance of the land, or of a part of it
  const std::shared_ptr<const InterfaceLaw> interface;       ///< penalty law if the table is hard

private:
  /// Returns the compliance of the whole land. Throws std::out_of_range if it is unknown.
  virtual std::shared_ptr<const ContactCompliance> whole_land_compliance() const;
  /// Returns the zone with its gaps at @p marks; the body's state is undefined.
  Zone &zone_at(unsigned int zone, const ring::Orientation &marks) const;
  /// Solves the contact of @p state on its zone, in the axes of the lines.
  void press(const ContactGuess &guess, ContactState &state) const;
  /// Returns @p guess in the axes of the lines, with the marks at @p marks. The previous penetration is used
  /// as it is and, if the crests have moved by whole lines, also rotated; the more successful variant comes
  /// first.
  RevolutionGuesses starts_from(const ContactGuess &guess, const ring::Orientation &marks) const;

  /// Returns nodal values rotated counter-clockwise by @p n lines.
  Eigen::VectorXd rotated_by_lines(const Eigen::VectorXd &nodal, long n) const;
  double line_spacing() const; ///< [rad]
  /// Returns the azimuth [rad] of the crests of the rim's waviness, or else the table's; 0 without waviness.
  double crest(const ring::Orientation &marks) const;
  /// Returns the index of the line nearest to the crests. Lines follow the crests: a narrow contact at a
  /// crest on a line at one phase and between lines at the next would not depend smoothly on the phase.
  long crest_line(const ring::Orientation &marks) const;
  /// Zone of the band about the contact radius; zone of the whole land, created on demand.
  mutable std::array<std::unique_ptr<Zone>, 2> zones;
};

} // namespace stemware::fem
