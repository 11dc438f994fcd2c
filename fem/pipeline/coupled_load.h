#pragma once

#include "fem/pipeline/foot_contact.h"
#include "fem/pipeline/ring_load.h"

#include <functional>
#include <memory>

namespace stemware::pipeline
{

/// The load of an elastic foot in balance at every spin: friction enters the moment that the table has to
/// answer, the moment enters the contact, the contact's load enters the friction (docs/theory/closures.md).
/// Each spin asked for is one self-consistent state of contact solutions, kept for the next time.
///
/// @p progress is called with the number of states after each new one. @p at_rest is the contact's load at
/// omega = 0, where the friction is known beforehand. The result keeps
/// @p foot alive. Its at_spin throws ContactFailure, and std::runtime_error where the balance is not found.
RingLoad coupled_contact_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                              const fem::LoadHarmonics &at_rest,
                              const std::function<void(std::size_t n_states)> &progress);

} // namespace stemware::pipeline
