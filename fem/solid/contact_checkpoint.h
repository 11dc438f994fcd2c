#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/solid/checkpoint_manifest.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stemware::fem
{

class SolidBody;

/// The state of a contact solve in files, from which it goes on when the program was killed: displacement and
/// table motions of the mesh that it was at, written whole after each Newton step. For bodies with a mesh
/// hierarchy; all ranks call every function together. In the folder only the files of its own manifest
/// (CheckpointManifest) are touched.
class ContactCheckpoint
{
public:
  /// State that was saved, for a solve to go on from.
  struct Kept
  {
    ContactStart start;
    std::vector<ContactIteration> history; ///< steps on the mesh that the state is of
  };

  /// @p folder is made where it does not exist. @p owner is the study that is run, whose solves take turns in
  /// the folder; @p problem is all that this solve depends on. While the folder keeps another solve of the
  /// same study, this one is not saved: the kept one goes on when it is its turn. Throws
  /// std::invalid_argument with one sentence when the folder cannot be made, keeps the state of another study
  /// or number of ranks, or holds other files of the names that are needed.
  ContactCheckpoint(const std::filesystem::path &folder, const std::string &owner,
                    const std::string &problem);

  /// Replaces what was saved before. Throws std::runtime_error on all ranks when one of them cannot write;
  /// what was saved before stays.
  void save(const SolidBody &body, const ContactStart &start, const std::vector<ContactIteration> &history);

  /// Gives @p body the state that was saved of it, and where its solve goes on; nothing, and the body as it
  /// is, where none was or it was of another mesh or solve. Throws std::runtime_error on all ranks where the
  /// file of one of them is missing, or not as it was written.
  std::optional<Kept> restore(SolidBody &body);

  /// Removes the files: the solve has ended.
  void remove();

private:
  /// Why the folder cannot be used; of the first rank alone.
  std::string trouble();
  bool write_manifest() const;
  std::filesystem::path state_file(unsigned long number, unsigned int rank) const;

  const std::filesystem::path folder;
  CheckpointManifest manifest;
  bool is_there = false; ///< the manifest is in the folder
  bool is_ours = true;   ///< and of this solve
};

} // namespace stemware::fem
