#pragma once

#include <cstddef>
#include <string>

namespace stemware::fem
{
struct ContactIteration; // a step of Newton's method, of which support/ knows the name alone
}

namespace stemware::pipeline
{

/// Listener to the progress of long work. Nobody listens unless a function is overridden; the console's
/// progress is made in app/. Not called from several threads at a time.
class Progress
{
public:
  virtual ~Progress() = default;

  /// A stage of the work has ended: "mesh_and_stiffness", "contact", "ring".
  virtual void stage_done(const std::string & /*stage*/) {}
  /// @p n_done pieces of @p what have been done; @p n_all is 0 if their number is unknown.
  virtual void pieces_done(const std::string & /*what*/, std::size_t /*n_done*/, std::size_t /*n_all*/) {}
  virtual void iteration(const fem::ContactIteration & /*step*/) {}
  /// Something that a reader of the console should know, with a word or two that name its subject.
  virtual void note(const std::string & /*subject*/, const std::string & /*text*/) {}
};

/// Progress without output.
inline Progress &silent_progress()
{
  static Progress silent;
  return silent;
}

} // namespace stemware::pipeline
