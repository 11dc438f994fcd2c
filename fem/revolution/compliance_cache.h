#pragma once

#include "fem/geometry/triangulation.h"
#include "fem/revolution/contact_compliance.h"

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Computes the compliances of the contact zone (boundary id 2) of the body of revolution with the meridional
/// section @p triangulation, fixed at boundary id 1 (docs/method/revolution.md, "One meridional problem per
/// harmonic"). K_n = K_0 + n K_1 + n^2 K_2 is integrated once; each harmonic is factorised (Cholesky) with
/// its own conditions on the axis, on deal.II's threads. @p interruption is called before each harmonic, from
/// any thread; its exceptions end the work. Throws std::invalid_argument for an inadmissible degree or mesh.
ContactCompliance compute_compliance(const dealii::Triangulation<2, 2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options = {},
                                     const std::function<void()> &interruption = {});

/// Cache of the compliances of bodies of revolution by mesh, material and options. Thread-safe; threads wait
/// for a compliance that is being computed. Compliances in use stay alive when the cache is emptied.
class ComplianceCache
{
public:
  /// Creates a cache of at most @p max_entries compliances, about 1 MB each; a full cache is emptied. @p
  /// interruption: as in compute_compliance().
  explicit ComplianceCache(std::size_t max_entries = 128, std::function<void()> interruption = {})
      : max_entries(max_entries)
      , interruption(std::move(interruption))
  {
  }

  /// Returns compute_compliance(), cached for equal arguments. Throws as compute_compliance().
  std::shared_ptr<const ContactCompliance> get(const dealii::Triangulation<2, 2> &triangulation,
                                               const ElasticMaterial &material,
                                               const MeridianOptions &options);

  /// Returns the number of calls of compute_compliance().
  unsigned int n_computed() const;

private:
  using Entry = std::shared_future<std::shared_ptr<const ContactCompliance>>;

  const std::size_t max_entries;
  const std::function<void()> interruption;
  mutable std::mutex mutex;
  std::map<std::vector<double>, Entry> entries;
  unsigned int computed = 0;
};

} // namespace stemware::fem
