#include "fem/revolution/compliance_cache.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <future>
#include <map>
#include <mutex>
#include <string>

namespace stemware::fem
{

namespace
{

using SharedCompliance = std::shared_ptr<const ContactCompliance>;

template <typename Number>
void append(std::string &key, const Number &number)
{
  key.append(reinterpret_cast<const char *>(&number), sizeof(number));
}

/// All that compute_compliance() reads, bit by bit: equal keys have equal compliances.
std::string key_of(const dealii::Triangulation<2> &triangulation, const ElasticMaterial &material,
                   const MeridianOptions &options)
{
  std::string key;
  append(key, material.young_modulus);
  append(key, material.poisson_ratio);
  append(key, options.degree);
  append(key, options.n_harmonics);
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    for (const unsigned int v : cell->vertex_indices())
    {
      append(key, cell->vertex(v)[0]);
      append(key, cell->vertex(v)[1]);
    }
    for (const unsigned int f : cell->face_indices())
    {
      // Edges may be curved.
      const dealii::Point<2> middle = cell->face(f)->center(true);
      append(key, middle[0]);
      append(key, middle[1]);
      append(key, cell->face(f)->boundary_id());
    }
  }
  return key;
}

std::size_t bytes_of(const ContactCompliance &compliance)
{
  std::size_t n_numbers = 0;
  for (const HarmonicCompliance &harmonic : compliance.harmonics)
    n_numbers +=
      static_cast<std::size_t>(harmonic.normal.size() + harmonic.radial.size() + harmonic.azimuthal.size());
  return n_numbers * sizeof(double);
}

} // namespace

struct ComplianceStore::Implementation
{
  struct Entry
  {
    std::shared_future<SharedCompliance> compliance;
    std::size_t n_bytes = 0; ///< 0 as long as it is being computed
    unsigned long last_use = 0;
  };

  /// The entry's future, and the promise to keep where nobody has computed it yet.
  std::shared_future<SharedCompliance> look_up(const std::string &key,
                                               std::unique_ptr<std::promise<SharedCompliance>> &promise)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    Entry &entry = entries[key];
    entry.last_use = ++n_uses;
    if (!entry.compliance.valid())
    {
      promise = std::make_unique<std::promise<SharedCompliance>>();
      entry.compliance = promise->get_future().share();
      ++n_computed;
    }
    return entry.compliance;
  }

  void keep(const std::string &key, std::size_t n_bytes)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    entries.at(key).n_bytes = n_bytes;
    total_bytes += n_bytes;
    while (total_bytes > max_bytes)
    {
      const auto oldest = std::min_element(entries.begin(), entries.end(),
                                           [](const auto &one, const auto &other)
                                           {
                                             // Those that are being computed come last.
                                             const auto rank = [](const Entry &entry)
                                             { return std::pair(entry.n_bytes == 0, entry.last_use); };
                                             return rank(one.second) < rank(other.second);
                                           });
      total_bytes -= oldest->second.n_bytes;
      entries.erase(oldest);
    }
  }

  void forget(const std::string &key)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    entries.erase(key);
  }

  std::size_t max_bytes = 0;
  mutable std::mutex mutex;
  std::map<std::string, Entry> entries;
  std::size_t total_bytes = 0;
  unsigned long n_uses = 0;
  unsigned int n_computed = 0;
};

ComplianceStore::ComplianceStore(std::size_t max_bytes)
    : implementation(std::make_unique<Implementation>())
{
  implementation->max_bytes = max_bytes;
}

ComplianceStore::~ComplianceStore() = default;

std::shared_ptr<const ContactCompliance> ComplianceStore::get(const dealii::Triangulation<2> &triangulation,
                                                              const ElasticMaterial &material,
                                                              const MeridianOptions &options)
{
  const std::string key = key_of(triangulation, material, options);
  std::unique_ptr<std::promise<SharedCompliance>> promise;
  const std::shared_future<SharedCompliance> future = implementation->look_up(key, promise);
  if (!promise)
    return future.get();
  try
  {
    promise->set_value(
      std::make_shared<ContactCompliance>(compute_compliance(triangulation, material, options)));
  }
  catch (...)
  {
    implementation->forget(key);
    promise->set_exception(std::current_exception());
    throw;
  }
  implementation->keep(key, bytes_of(*future.get()));
  return future.get();
}

unsigned int ComplianceStore::n_computed() const
{
  const std::lock_guard<std::mutex> lock(implementation->mutex);
  return implementation->n_computed;
}

} // namespace stemware::fem
