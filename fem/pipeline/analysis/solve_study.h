#pragma once

#include "fem/pipeline/analysis/study_result.h"
#include "fem/pipeline/coupling/phase_contact.h"

#include <functional>
#include <memory>

namespace stemware::pipeline
{

/// What a caller may want to see of a study while it is solved; members may be left empty.
struct StudyObserver
{
  std::function<void(const FootContact &)> foot_made;
  std::function<void(const fem::ContactIteration &)> newton_step;
  std::function<void(const FootContact &, const FootContactResult &)> contact_found; ///< at rest
  std::function<void(std::size_t n_states)> balance_found; ///< after each spin with contact in balance
  std::function<void(const std::string &stage)> stage_done;
  /// Something that a reader of the terminal should know, with a word or two that name its subject.
  std::function<void(const std::string &subject, const std::string &text)> note;
};

/// The load of a study, with the foot that carries it.
struct StudyLoad
{
  RingLoad load;
  std::shared_ptr<FootContact> foot;     ///< nothing where the load does not come from a contact
  std::optional<ContactFigures> contact; ///< at rest; without the resolved friction
  std::optional<PhasedLoad>
    phased = {}; ///< where rim or table are out of flat; `load` is its mean at every spin
};

/// The load on the ring, from wherever @p study wants it. MPI must have been started for a contact;
/// collective over all ranks. Throws BadInput, ContactFailure.
StudyLoad find_load(const Study &study, const StudyObserver &observer = {});

/// The same for one of many studies, whose feet share what they can in @p store. Bodies of revolution are not
/// collective, and several threads may be at it.
StudyLoad find_load(const Study &study, fem::ComplianceStore &store, const StudyObserver &observer = {});

/// The whole study: the load, and what follows from it for torque, spin, truncations and closures. Writes
/// nothing. Throws as find_load, and std::runtime_error where a balance or a terminal spin is not found.
StudyResult solve_study(const Study &study, const StudyObserver &observer = {});

} // namespace stemware::pipeline
