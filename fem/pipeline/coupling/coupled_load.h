#pragma once

#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/coupling/ring_load.h"

#include <functional>
#include <memory>
#include <string>

namespace stemware::pipeline
{

/// Whether the load of an elastic foot in balance depends on the spin: the closure lets friction act back on
/// the moment, or friction deforms the foot.
bool follows_spin(const Study &study);

/// The load of an elastic foot as Load/Coupling wants it.
///
/// frozen: @p at_rest at every spin. exact and response: in balance at every spin, where friction enters the
/// moment that the table has to answer, the moment enters the contact, the contact's load enters the
/// friction (docs/theory/closures.md). exact answers each moment by a contact solution, response by a curve
/// of contact solutions over the moment ratio. Where the spin does not matter to the load (a closure without
/// the moment of friction, no friction coupling), both are the load at rest.
///
/// @p at_rest is the contact's load at omega = 0, where the friction is known beforehand. @p progress is
/// called with the number of balanced spins after each new one. The result keeps @p foot alive. Its at_spin
/// throws fem::ContactFailure, and std::runtime_error where the balance is not found. Throws BadInput where a
/// curve over the moment ratio cannot say everything, std::runtime_error where it misses its tolerance.
RingLoad contact_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                      const fem::LoadHarmonics &at_rest,
                      const std::function<void(std::size_t n_states)> &progress);

/// A sentence for the terminal where the load is frozen although the spin would change it; empty elsewhere.
std::string frozen_note(const Study &study);

/// The same load for curves of thousands of values on spins from @p lower to @p upper, where each value would
/// be a balance of its own: interpolated between exact ones, to 1e-9 of a_0 where 200 of them suffice, else
/// to 1e-7 or 1e-5, else exact. Notes the error in load.coupling. A load that is not costly is returned as it
/// is.
LoadAtSpin for_many_spins(const RingLoad &load, double lower, double upper);

} // namespace stemware::pipeline
