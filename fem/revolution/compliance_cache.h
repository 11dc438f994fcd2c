#pragma once

#include "fem/revolution/meridian_problem.h"

#include <cstddef>
#include <memory>

namespace stemware::fem
{

/// Compliances of bodies of revolution, each computed once for everybody who asks for the same mesh, material
/// and options.
///
/// Several threads may ask at a time; whoever asks for a compliance that another thread computes waits for
/// it. What has not been asked for longest is forgotten when all of them together take more than @p
/// max_bytes.
class ComplianceStore
{
public:
  explicit ComplianceStore(std::size_t max_bytes = std::size_t(1) << 28);
  ~ComplianceStore();

  /// What compute_compliance() returns; throws as that.
  std::shared_ptr<const ContactCompliance> get(const dealii::Triangulation<2, 2> &triangulation,
                                               const ElasticMaterial &material,
                                               const MeridianOptions &options);

  /// How often compute_compliance() has been called.
  unsigned int n_computed() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace stemware::fem
