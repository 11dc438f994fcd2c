#pragma once

#include "fem/revolution/contact_compliance.h"

#include <cstddef>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace stemware::fem
{

/// Compliances of bodies of revolution, each computed once for everybody who asks for equal meshes, materials
/// and options.
///
/// Several threads may ask at a time; whoever asks for a compliance that another thread computes waits for
/// it. Compliances that somebody holds stay alive whatever the cache does.
class ComplianceCache
{
public:
  /// Holds at most @p max_entries compliances, about a megabyte each: a full cache is emptied.
  explicit ComplianceCache(std::size_t max_entries = 128)
      : max_entries(max_entries)
  {
  }

  /// The compliance by compute_compliance(), kept for equal arguments; throws like that function.
  std::shared_ptr<const ContactCompliance> get(const dealii::Triangulation<2, 2> &triangulation,
                                               const ElasticMaterial &material,
                                               const MeridianOptions &options);

  /// How often compute_compliance() has been called.
  unsigned int n_computed() const;

private:
  /// The part of a compliance that is known with @p factor times as many harmonics; nothing where there is
  /// none.
  std::shared_ptr<const ContactCompliance>
  with_more_harmonics(std::vector<double> key, const MeridianOptions &options, unsigned int factor);

  using Entry = std::shared_future<std::shared_ptr<const ContactCompliance>>;

  const std::size_t max_entries;
  mutable std::mutex mutex;
  std::map<std::vector<double>, Entry> entries;
  unsigned int computed = 0;
};

} // namespace stemware::fem
