#include "fem/revolution/compliance_cache.h"

#include "fem/revolution/meridian_space.h"
#include "fem/revolution/parallel_for.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <string>
#include <tbb/task_arena.h>

namespace stemware::fem
{

namespace
{

/// Index of the number of harmonics in the result of key_of().
constexpr std::size_t harmonics_place = 3;

/// Returns all inputs of compute_compliance(). Equal inputs give bitwise equal compliances.
std::vector<double> key_of(const dealii::Triangulation<2> &triangulation, const ElasticMaterial &material,
                           const MeridianOptions &options)
{
  std::vector<double> key = { material.young_modulus,
                              material.poisson_ratio,
                              static_cast<double>(options.degree),
                              static_cast<double>(options.n_harmonics),
                              options.inner_radius,
                              options.outer_radius };
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    for (const unsigned int v : cell->vertex_indices())
      key.insert(key.end(), { cell->vertex(v)[0], cell->vertex(v)[1] });
    for (const unsigned int f : cell->face_indices())
    {
      // Curved edges with equal vertices differ in their centres.
      const dealii::Point<2> middle = cell->face(f)->center(true);
      key.insert(key.end(), { middle[0], middle[1], static_cast<double>(cell->face(f)->boundary_id()) });
    }
  }
  return key;
}

std::shared_ptr<const ContactCompliance> truncated(ContactCompliance compliance,
                                                   const MeridianOptions &options)
{
  compliance.tail = compliance.harmonics[options.tail_harmonic()];
  compliance.harmonics.resize(options.n_harmonics + 1);
  return std::make_shared<const ContactCompliance>(std::move(compliance));
}

} // namespace

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

std::shared_ptr<const ContactCompliance> ComplianceCache::get(const dealii::Triangulation<2> &triangulation,
                                                              const ElasticMaterial &material,
                                                              const MeridianOptions &options)
{
  material.validate(); // a NaN would break the comparison of keys
  const std::vector<double> key = key_of(triangulation, material, options);
  std::promise<std::shared_ptr<const ContactCompliance>> promise;
  {
    std::unique_lock<std::mutex> lock(mutex);
    for (const unsigned int factor : { 2, 4, 1 })
    {
      std::vector<double> with_more_harmonics = key;
      with_more_harmonics[harmonics_place] *= factor;
      const auto found = entries.find(with_more_harmonics);
      if (found == entries.end())
        continue;
      const Entry entry = found->second;
      lock.unlock();
      return factor == 1 ? entry.get() : truncated(*entry.get(), options);
    }
    if (entries.size() >= max_entries)
      entries.clear();
    entries.emplace(key, promise.get_future());
    ++computed;
  }
  try
  {
    const auto compliance = std::make_shared<const ContactCompliance>(
      compute_compliance(triangulation, material, options, interruption));
    promise.set_value(compliance);
    return compliance;
  }
  catch (...)
  {
    promise.set_exception(std::current_exception());
    const std::lock_guard<std::mutex> lock(mutex);
    entries.erase(key);
    throw;
  }
}

unsigned int ComplianceCache::n_computed() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return computed;
}

} // namespace stemware::fem
