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
  /// Contact closer to rest, for a predicted or previous contact beyond the limit point of the balance.
  std::optional<ContactStart> nearer_to_rest = {};
  bool waviness_has_rotated = false; ///< the waviness has rotated since the previous contacts
};

/// Solved contact of a body of revolution.
struct RevolutionContact
{
  ContactSolution solution;
  std::vector<ContactIteration> history; ///< Newton steps of the last solve on the unsoftened interface
  /// Index of the successful guess in RevolutionGuesses::previous, if any.
  std::optional<std::size_t> start_used;
};

/// Solves the contact of @p body on @p law (a penalty law of @p interface if the table is hard) under @p
/// conditions; the body must have the state of the previous contacts. Newton's method starts from a sequence
/// of initial guesses until the contact is stable. The order is: predicted contact, previous contacts,
/// previous contacts on a softened interface, contact closer to rest, cold start (on an interface that is
/// soft enough for a wide band, then stiffened step by step), continuation in the moment. If the continuation
/// ends before the full moment, the tilted glass tips. Throws ContactFailure.
RevolutionContact solve_revolution_contact(const RevolutionSetup &setup, const InterfaceLaw &interface,
                                           BodyOfRevolution &body, TableLaw &law,
                                           const LinearConditions &conditions,
                                           const RevolutionGuesses &starts);

} // namespace stemware::fem
