#include "fem/revolution/compute_compliance.h"

#include "fem/revolution/meridian_space.h"
#include "fem/revolution/parallel_for.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <tbb/task_arena.h>

namespace stemware::fem
{

ContactCompliance compute_compliance(const dealii::Triangulation<2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options,
                                     const std::function<void()> &interruption)
{
  material.validate();
  if (options.degree < 1 || options.degree > 4)
    throw std::invalid_argument("Degree = " + std::to_string(options.degree) +
                                " is not allowed for a body of revolution; give 1, 2, 3 or 4.");
  const MeridianSpace space(triangulation, material, options.degree);
  Eigen::VectorXd radii(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    radii(i) = space.contact_radius(i);
  const auto [first, size] = nodes_between(radii, options.degree, options.inner_radius, options.outer_radius);
  ContactCompliance result;
  result.degree = options.degree;
  result.n_meridian_unknowns = space.n_dofs();
  result.radii = radii.segment(first, size);
  result.n_inside = first;
  result.n_outside = radii.size() - first - size;
  result.harmonics.resize(options.n_harmonics + 1);
  // An exception that leaves the parallel loop would cancel later parallel work of deal.II.
  std::exception_ptr interrupted;
  std::atomic<bool> is_interrupted = false;
  const auto goes_on = [&]
  {
    try
    {
      if (interruption && !is_interrupted)
        interruption();
    }
    catch (...)
    {
      if (!is_interrupted.exchange(true))
        interrupted = std::current_exception();
    }
    return !is_interrupted;
  };
  // Without isolation, a thread that waits here could start another study, which could wait for this
  // compliance (deadlock).
  tbb::this_task_arena::isolate(
    [&, first = first, size = size]
    {
      std::array<std::unique_ptr<const MeridianSpace::Compliances>, 3> of; // for harmonics 0, 1, and >= 2
      parallel_for(3, [&](unsigned int n)
                   { of[n] = std::make_unique<const MeridianSpace::Compliances>(space, n, first, size); });
      parallel_for(options.n_harmonics + 2,
                   [&](unsigned int n)
                   {
                     if (!goes_on())
                       return;
                     const bool is_beyond = n > options.n_harmonics;
                     const unsigned int harmonic = is_beyond ? options.tail_harmonic() : n;
                     (is_beyond ? result.tail : result.harmonics[n]) =
                       (*of[std::min(harmonic, 2u)])(harmonic);
                   });
    });
  if (interrupted)
    std::rethrow_exception(interrupted);
  return result;
}

} // namespace stemware::fem
