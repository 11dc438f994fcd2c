#pragma once

#include <cstddef>
#include <string>

namespace stemware::fem
{
struct ContactIteration; // a step of Newton's method
}

namespace stemware::pipeline
{

/// Observer of long work, without output by default. Not called from several threads simultaneously.
class Progress
{
public:
  virtual ~Progress() = default;

  /// Reports the end of a stage: "mesh_and_stiffness", "contact", "ring".
  virtual void stage_done(const std::string & /*stage*/) {}
  /// Reports that @p n_done of @p n_all pieces of @p what are done; @p n_all is 0 if unknown.
  virtual void pieces_done(const std::string & /*what*/, std::size_t /*n_done*/, std::size_t /*n_all*/) {}
  virtual void iteration(const fem::ContactIteration & /*step*/) {}
  /// Reports a note for the console, under a heading of one or two words.
  virtual void note(const std::string & /*subject*/, const std::string & /*text*/) {}
};

/// Returns a progress object without output.
inline Progress &silent_progress()
{
  static Progress silent;
  return silent;
}

} // namespace stemware::pipeline
