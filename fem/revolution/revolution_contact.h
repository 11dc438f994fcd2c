#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/revolution_setup.h"

#include <optional>
#include <vector>

namespace stemware::fem
{

/// Where a body of revolution looks for a contact, in the axes of its lines.
struct RevolutionStarts
{
  std::optional<ContactStart> expected = {};
  std::vector<ContactStart> before = {}; ///< contacts nearby, the most promising first
  bool crests_have_moved = false;        ///< since those
};

/// The contact of a body of revolution under conditions on its forces: Newton's method from one start after
/// the other, until one leads to a contact in which the glass stays.
///
/// First comes what is expected, then the contacts nearby, then these on a softened interface; then a cold
/// start: the interface is softened until it carries on a wide band, and stiffened step by step. At last the
/// moment grows from none to the whole in small steps; a leaning glass whose path ends before that tips.
class RevolutionContact
{
public:
  /// Keeps references to all. @p interface and @p law are the table under @p body, a hard one as a stiff
  /// spring.
  RevolutionContact(const RevolutionSetup &setup, const InterfaceLaw &interface, BodyOfRevolution &body,
                    TableLaw &law, const LinearConditions &conditions);

  /// The body's state is that of the contacts nearby. Throws ContactFailure.
  ContactSolution solve(const RevolutionStarts &starts);

  /// Newton steps of the last solve on the interface as it is.
  const std::vector<ContactIteration> &history() const { return steps; }

  /// Index of the one of RevolutionStarts::before that has led to the solution, if one has.
  std::optional<std::size_t> start_used() const { return used; }

private:
  /// Stopping rule; the steps go to history().
  ContactControl contact_control();
  /// solve_contact() from @p start, given up soon where it is not near.
  ContactSolution solve_near(const ContactStart &start);
  /// Solution from @p start on a softened interface.
  ContactSolution solve_softened(const ContactStart &start);
  /// Cold solution under @p under; @p largest_step: by how much the interface is stiffened at once.
  ContactSolution solve_cold(const LinearConditions &under, double largest_step);
  /// Solution from @p at on the interface softened by @p softness, in few steps, to the interface as it is;
  /// @p hopeless_residual as in ContactControl.
  ContactSolution stiffen(const LinearConditions &under, double softness, ContactStart at,
                          double largest_step,
                          double hopeless_residual = std::numeric_limits<double>::infinity());
  /// Whether the glass stays where @p solution has it: one that leans may have a second balance, beyond which
  /// it tips. The steadiness tells the two apart: it is positive in the first and vanishes where they meet.
  /// Completes the steadiness of a solution that took no step.
  bool is_stable(ContactSolution &solution) const;

  const RevolutionSetup &setup;
  const InterfaceLaw &interface;
  BodyOfRevolution &body;
  TableLaw &law;
  const LinearConditions &conditions;
  std::optional<std::size_t> used;
  std::vector<ContactIteration> steps;
};

} // namespace stemware::fem
