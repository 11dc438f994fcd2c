#pragma once

#include <cstddef>
#include <string>

namespace stemware::pipeline
{

/// One step of an iterative solver.
struct SolverIteration
{
  unsigned int number = 0;
  unsigned int n_active = 0;  ///< size of the active set
  unsigned int n_changed = 0; ///< how many of its members differ from the step before
  double residual = 0;        ///< relative
  double step_length = 0;     ///< share of the Newton increment that was taken
  unsigned int linear_iterations = 0;
};

/// Listener to the progress of long work. Nobody listens unless a function is overridden; the console's
/// progress is made in app/. Not called from several threads at a time.
class Progress
{
public:
  virtual ~Progress() = default;

  /// A stage of the work has ended: "mesh_and_stiffness", "contact", "ring".
  virtual void stage_done(const std::string & /*stage*/) {}
  /// @p n_done pieces of @p what have been done; @p n_all is 0 where nobody knows how many there will be.
  virtual void pieces_done(const std::string & /*what*/, std::size_t /*n_done*/, std::size_t /*n_all*/) {}
  virtual void iteration(const SolverIteration & /*step*/) {}
  /// Something that a reader of the console should know, with a word or two that name its subject.
  virtual void note(const std::string & /*subject*/, const std::string & /*text*/) {}
};

/// A progress that nobody listens to.
inline Progress &silent_progress()
{
  static Progress silent;
  return silent;
}

} // namespace stemware::pipeline
