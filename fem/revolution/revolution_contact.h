#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/revolution_setup.h"

#include <optional>
#include <vector>

namespace stemware::fem
{

/// Initial guesses of a body of revolution, in the axes of its lines.
struct RevolutionGuesses
{
  std::optional<ContactStart> predicted = {};
  std::vector<ContactStart> previous = {}; ///< contacts nearby, the most promising first
  bool waviness_has_rotated = false;       ///< since those
};

/// Contact of a body of revolution under conditions on its forces: Newton's method from one initial guess
/// after the other, until a stable contact is found.
///
/// The order is: the predicted contact, the contacts nearby, these on a softened interface, and a cold
/// start. The cold start softens the interface until the loaded band is wide, and stiffens it step by step.
/// The last resort is continuation in the moment; a leaning glass whose path ends before the full moment
/// tips.
class RevolutionContact
{
public:
  /// Keeps references to all arguments. @p interface and @p law are the table under @p body; a hard one is
  /// a stiff spring.
  RevolutionContact(const RevolutionSetup &setup, const InterfaceLaw &interface, BodyOfRevolution &body,
                    TableLaw &law, const LinearConditions &conditions);

  /// Solves the contact; the body's state is that of the contacts nearby. Throws ContactFailure.
  ContactSolution solve(const RevolutionGuesses &starts);

  /// Returns the Newton steps of the last solve on the unsoftened interface.
  const std::vector<ContactIteration> &history() const { return steps; }

  /// Returns the index in RevolutionGuesses::previous of the initial guess that led to the solution, if one
  /// did.
  std::optional<std::size_t> start_used() const { return used; }

private:
  /// Returns the stopping rule; steps are recorded in history().
  ContactControl contact_control();
  /// Calls solve_contact() from @p start, which is given up soon if it is not near.
  ContactSolution solve_near(const ContactStart &start);
  /// Returns the solution from @p start on a softened interface.
  ContactSolution solve_softened(const ContactStart &start);
  /// Returns the cold solution under @p under; @p largest_step: largest factor of stiffening at once.
  ContactSolution solve_cold(const LinearConditions &under, double largest_step);
  /// Solution from @p at on the interface softened by @p softness, in few steps, to the interface as it is;
  /// @p divergence_residual as in ContactControl.
  ContactSolution stiffen(const LinearConditions &under, double softness, ContactStart at,
                          double largest_step,
                          double divergence_residual = std::numeric_limits<double>::infinity());
  /// Returns whether @p solution is the stable balance. A leaning glass may have a second balance, beyond
  /// which it tips. The stability margin is positive in the first and vanishes where the two meet. Completes
  /// the stability margin of a solution without steps.
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
