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
  bool waviness_has_rotated = false;       ///< the waviness has rotated since the previous contacts
};

/// Contact of a body of revolution under conditions on its forces: Newton's method from a sequence of initial
/// guesses until the contact is stable. The order is: predicted contact, previous contacts, previous contacts
/// on a softened interface, cold start (on an interface that is soft enough for a wide band, then stiffened
/// step by step), continuation in the moment. If the continuation ends before the full moment, the tilted
/// glass tips.
class RevolutionContact
{
public:
  /// Keeps references. @p interface, @p law: table under @p body; a penalty law if the table is hard.
  RevolutionContact(const RevolutionSetup &setup, const InterfaceLaw &interface, BodyOfRevolution &body,
                    TableLaw &law, const LinearConditions &conditions);

  /// Solves the contact; the body must have the state of the previous contacts. Throws ContactFailure.
  ContactSolution solve(const RevolutionGuesses &starts);

  /// Returns the Newton steps of the last solve on the unsoftened interface.
  const std::vector<ContactIteration> &history() const { return steps; }

  /// Returns the index of the successful guess in RevolutionGuesses::previous, if any.
  std::optional<std::size_t> start_used() const { return used; }

private:
  /// Returns the stopping rule; steps are recorded in history().
  ContactControl contact_control();
  /// Calls solve_contact() from @p start, with an early stop if the residual stays large.
  ContactSolution solve_from(const ContactStart &start);
  /// Returns the solution from @p start on a softened interface.
  ContactSolution solve_softened(const ContactStart &start);
  /// Returns the solution under @p under from a cold start. @p largest_step: factor of a stiffening, at most.
  ContactSolution solve_cold(const LinearConditions &under, double largest_step);
  /// Returns the solution from @p at on an interface softer by the factor @p softness, stiffened in few
  /// steps; @p divergence_residual as in ContactControl.
  ContactSolution stiffen(const LinearConditions &under, double softness, ContactStart at,
                          double largest_step,
                          double divergence_residual = std::numeric_limits<double>::infinity());
  /// Returns whether @p solution is stable: a leaning glass may have a second, unstable balance, of negative
  /// stability margin. Completes the stability margin of a solution without steps.
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
