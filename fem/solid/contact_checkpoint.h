#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/solid/solid_body.h"

#include <filesystem>
#include <optional>
#include <string>

namespace stemware::fem
{

/// The state of a contact solve in files, from which it goes on when the program was killed: displacement and
/// table motions of the mesh that it was at, written whole after each Newton step. For bodies with a mesh
/// hierarchy; all ranks call every function together.
class ContactCheckpoint
{
public:
  /// @p folder is made where it does not exist. @p problem is all that the solve depends on: files of another
  /// problem, of another number of ranks, or of a program that saves something else, are no checkpoint of
  /// this one. Throws std::invalid_argument when the folder cannot be made.
  ContactCheckpoint(const std::filesystem::path &folder, const std::string &problem);

  /// Replaces what was saved before. Throws std::runtime_error on all ranks when one of them cannot write;
  /// what was saved before stays.
  void save(const SolidBody &body, const ContactStart &start);

  /// Gives @p body the state that was saved of it, and where its solve goes on; nothing, and the body as it
  /// is, where none was or it was of another mesh. Removes what is no checkpoint of this problem. Throws
  /// std::runtime_error on all ranks where the file of one of them is missing or not as long as it was.
  std::optional<ContactStart> restore(SolidBody &body);

  /// Removes the files: the solve has ended.
  void remove();

private:
  /// Removes the files of every problem and rank; of the first rank alone.
  void clear() const;

  std::filesystem::path state_file(unsigned long number, unsigned int rank) const;

  const std::filesystem::path folder;
  const std::string header; ///< what is saved, number of ranks and problem
  unsigned long number = 0; ///< of the last state
};

} // namespace stemware::fem
