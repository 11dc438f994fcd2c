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
  std::vector<ContactStart> previous = {}; ///< previous contacts, the most promising first
  bool waviness_has_rotated = false;       ///< true if the waviness has rotated since the previous contacts
};

/// Contact of a body of revolution under conditions on its forces: Newton's method from a sequence of initial
/// guesses until a stable contact is found.
///
/// The order is: predicted contact, previous contacts, previous contacts on a softened interface, cold start.
/// The cold start softens the interface until the loaded band is wide, and stiffens it step by step. The last
/// resort is continuation in the moment; if it ends before the full moment, the tilted glass tips.
class RevolutionContact
{
public:
  /// Keeps references to all arguments. @p interface and @p law: table under @p body, a penalty law if the
  /// table is hard.
  RevolutionContact(const RevolutionSetup &setup, const InterfaceLaw &interface, BodyOfRevolution &body,
                    TableLaw &law, const LinearConditions &conditions);

  /// Solves the contact; the body must have the state of the previous contacts. Throws ContactFailure.
  ContactSolution solve(const RevolutionGuesses &starts);

  /// Returns the Newton steps of the last solve on the unsoftened interface.
  const std::vector<ContactIteration> &history() const { return steps; }

  /// Returns the index in RevolutionGuesses::previous of the initial guess that led to the solution, if one
  /// did.
  std::optional<std::size_t> start_used() const { return used; }

private:
  /// Returns the stopping rule; steps are recorded in history().
  ContactControl contact_control();
  /// Calls solve_contact() from @p start, with an early stop if the residual stays large.
  ContactSolution solve_from(const ContactStart &start);
  /// Returns the solution from @p start on a softened interface.
  ContactSolution solve_softened(const ContactStart &start);
  /// Returns the solution under the conditions @p under from a cold start; @p largest_step: largest factor of
  /// one stiffening step.
  ContactSolution solve_cold(const LinearConditions &under, double largest_step);
  /// Returns the solution from @p at by stiffening the interface from the factor @p softness to its own
  /// stiffness in few steps; @p divergence_residual as in ContactControl.
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
