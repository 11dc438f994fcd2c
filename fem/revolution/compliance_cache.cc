#include "fem/revolution/compliance_cache.h"

#include "fem/revolution/compute_compliance.h"

#include <deal.II/grid/tria.h>

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

} // namespace

std::shared_ptr<const ContactCompliance> ComplianceCache::with_more_harmonics(std::vector<double> key,
                                                                              const MeridianOptions &options,
                                                                              unsigned int factor)
{
  key[harmonics_place] = factor * options.n_harmonics;
  std::unique_lock<std::mutex> lock(mutex);
  const auto found = entries.find(key);
  if (found == entries.end())
    return nullptr;
  const Entry entry = found->second;
  lock.unlock();
  ContactCompliance fewer = *entry.get();
  fewer.tail = fewer.harmonics[options.tail_harmonic()];
  fewer.harmonics.resize(options.n_harmonics + 1);
  return std::make_shared<const ContactCompliance>(std::move(fewer));
}

std::shared_ptr<const ContactCompliance> ComplianceCache::get(const dealii::Triangulation<2> &triangulation,
                                                              const ElasticMaterial &material,
                                                              const MeridianOptions &options)
{
  material.validate(); // a NaN would break the comparison of keys
  const std::vector<double> key = key_of(triangulation, material, options);
  for (const unsigned int factor : { 2, 4 })
    if (const auto more = with_more_harmonics(key, options, factor))
      return more;
  std::promise<std::shared_ptr<const ContactCompliance>> promise;
  {
    std::unique_lock<std::mutex> lock(mutex);
    if (const auto found = entries.find(key); found != entries.end())
    {
      const Entry entry = found->second;
      lock.unlock();
      return entry.get();
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
