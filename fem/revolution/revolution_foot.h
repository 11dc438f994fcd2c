#pragma once

#include "fem/contact/foot.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/revolution_setup.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// The foot as a body of revolution on its table. Solving is not collective; it is started from what
/// solutions under the same demand at other spins let expect, else from the solution before, on a
/// softened interface where that fails, or where the crests have moved under a hard contact; cold where that
/// fails too: then the interface is first softened until it carries on a wide band, and stiffened step by
/// step. At last the moment grows from none to the whole in small steps; a leaning glass whose path ends
/// before that tips.
class RevolutionFoot : public Foot
{
public:
  /// Computes the compliances. Throws std::invalid_argument for a setup that is not allowed.
  explicit RevolutionFoot(const RevolutionSetup &setup);
  /// Takes the compliances from @p cache, which other feet share.
  RevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache);

  FootDescription description() const override;
  FootCapabilities capabilities() const override;
  ContactState solve(const ContactDemand &demand, const Slip &slip = {},
                     const std::function<void(const ContactIteration &)> &progress = {}) override;
  void resume(const ContactState &state) override;
  /// Where neither is out of flat and both bodies and hardness are the same; others have nothing to tell.
  void start_like(const Foot &similar) override;
  unsigned int n_resolved_harmonics() const override;
  LoadHarmonics gather(const ContactState &state, const std::vector<double> &ring_radii,
                       unsigned int n_harmonics) override;
  std::vector<PointForce> point_forces(const ContactState &state) override;
  PressureMap pressure_map(const ContactState &state) override;
  std::vector<FieldFile> fields(const ContactState &state) override;
  /// Of a foot and table that are flat; throws as estimate_mesh_error().
  std::optional<MeshError> mesh_error(const ContactState &state, const ContactGoal &goal,
                                      bool with_cells) override;

  const BodyOfRevolution &elastic_body() const { return zones.back()->body; }

private:
  /// A part of the land with the body that is loaded there alone.
  struct Zone
  {
    Zone(const RevolutionFoot &foot, Eigen::Index first, Eigen::Index size);

    const Eigen::Index first; ///< contact node of the land
    BodyOfRevolution body;
    const std::unique_ptr<TableLaw> law;
  };

  /// A solution and what it was found for.
  struct Solved
  {
    /// Normal force, moment and tilt moment; the friction's moment depends on the spin and is left out.
    static std::array<double, 4> numbers_of(const ContactDemand &demand);

    std::array<double, 4> demand; ///< numbers_of()
    double spin;                  ///< Slip::spin_per_speed
    ContactStart start;
  };

  double gap(double radius, double azimuth) const;
  /// The zone of @p state with its gap at the state's phase.
  Zone &zone_of(const ContactState &state);
  void set_orientation(const FootOrientation &orientation);
  /// Nodal values turned counter-clockwise by @p n lines.
  Eigen::VectorXd turned_by_lines(const Eigen::VectorXd &nodal, long n) const;
  double line_spacing() const; ///< [rad]
  /// Azimuth of the crests at `phase`, of the rim's waviness, else of the table's; 0 where there is none
  /// [rad].
  double crest() const;
  /// The line that the crests are next to. The lines go with the crests: else a narrow contact at a crest,
  /// between lines at one phase and on a line at the next, would not depend smoothly on the phase. Whole
  /// lines are no change.
  long crest_line() const;
  /// What is left: the azimuth of the first line, at most half a line from that of travel [rad].
  double axis() const;
  /// The contact's solution in the axes of the lines, from that in the slip frame.
  ContactSolution in_axes_of_lines(ContactSolution solution) const;
  /// Elements of the land that lie within @p reach of the contact radius, all of them where that is 0.
  void add_zone(double reach);
  /// The contact in the axes of the lines, on a zone that it does not leave.
  ContactSolution press(const ContactDemand &demand, const Slip &slip);
  ContactSolution solve_from_before(const ContactDemand &demand, const Slip &slip);
  /// Keeps the solution before for predict().
  void remember(const ContactDemand &demand, const Slip &slip);
  /// The polynomial in the spin through the nearest solutions under the same demand; where fewer than two are
  /// near enough, that of the similar foot; without one, the nearest solution. Nothing where there is none.
  std::optional<ContactStart> predict(const ContactDemand &demand, const Slip &slip) const;
  /// The polynomial through those of @p points that are nearest to @p spin, at least @p n_least of them.
  static std::optional<ContactStart> between(std::vector<const Solved *> points, double spin,
                                             std::size_t n_least);
  /// @p one of @p other at the nodes of the zone in use.
  ContactStart on_own_nodes(const ContactStart &one, const RevolutionFoot &other) const;
  /// solve_contact() from @p start, given up soon where it is not near.
  ContactSolution solve_near(const LinearConditions &conditions, const ContactStart &start);
  /// From @p start on a softened interface.
  ContactSolution solve_softened(const LinearConditions &conditions, const ContactStart &start);
  /// @p largest_step: by how much the interface is stiffened at once.
  ContactSolution solve_cold(const LinearConditions &conditions, double largest_step);
  /// From @p at on the interface softened by @p softness, in few steps, to the interface as it is;
  /// @p hopeless_residual as in ContactControl.
  ContactSolution stiffen(const LinearConditions &conditions, double softness, ContactStart at,
                          double largest_step,
                          double hopeless_residual = std::numeric_limits<double>::infinity());
  /// Whether the glass stays where @p solution has it: one that leans may have a second balance, beyond which
  /// it tips. The two are told apart by the sign of the determinant of what is set against motions, which
  /// vanishes where they meet and is that of a glass whose weight does not count at the first.
  bool is_stable(const LinearConditions &conditions, const ContactSolution &solution);
  /// Whether the contact has come to a border of the zone that is none of the land.
  bool has_left_zone() const;

  const RevolutionSetup setup;
  const std::shared_ptr<const ContactCompliance> compliance; ///< of the whole land
  const std::shared_ptr<const InterfaceLaw> interface;       ///< a hard one as a stiff spring
  FootOrientation phase;                                     ///< that the gaps stand at
  /// The last one is in use: first a band about the contact radius, then the whole land if the contact leaves
  /// it.
  std::vector<std::unique_ptr<Zone>> zones;
  ComplianceCache finer{ 4 };         ///< of mesh_error()
  std::optional<ContactStart> before; ///< the solution before, of the zone in use
  std::vector<Solved> recent;         ///< solutions of the zone in use at the present phase, oldest first
  std::vector<Solved> of_similar;     ///< those of start_like(), on the nodes of the zone in use
  std::optional<ContactStart> turned; ///< the same turned with the crests since
  bool crests_have_moved = false;     ///< since the solution before
  /// Whether the last start that led to a solution after a turn of the crests was the turned one.
  bool goes_with_crests = false;
};

} // namespace stemware::fem
