#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/meridian_space.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace stemware::fem
{

ContactCompliance compute_compliance(const dealii::Triangulation<2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options)
{
  material.validate();
  if (options.degree < 1 || options.degree > 4)
    throw std::invalid_argument("Degree = " + std::to_string(options.degree) +
                                " is not allowed for a body of revolution; give 1, 2, 3 or 4.");
  const MeridianSpace space(triangulation, material, options.degree);
  ContactCompliance result;
  result.degree = options.degree;
  result.n_meridian_unknowns = space.n_dofs();
  result.radii.resize(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    result.radii(i) = space.contact_radius(i);
  result.harmonics.resize(options.n_harmonics + 1);
  // Isolated: a thread that waits here for its last harmonic must not begin another study, which may wait for
  // this very compliance.
  tbb::this_task_arena::isolate(
    [&]
    {
      std::array<std::unique_ptr<const MeridianSpace::Compliances>, 3> of; // harmonics 0, 1, and from 2 on
      tbb::parallel_for(0u, 3u,
                        [&](unsigned int n)
                        { of[n] = std::make_unique<const MeridianSpace::Compliances>(space, n); });
      tbb::parallel_for(0u, options.n_harmonics + 2,
                        [&](unsigned int n)
                        {
                          const bool is_beyond = n > options.n_harmonics;
                          const unsigned int harmonic = is_beyond ? options.beyond() : n;
                          (is_beyond ? result.beyond : result.harmonics[n]) =
                            (*of[std::min(harmonic, 2u)])(harmonic);
                        });
    });
  return result;
}

} // namespace stemware::fem
