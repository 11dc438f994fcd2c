#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"

#include <memory>
#include <optional>

namespace stemware::pipeline
{

/// Chooses the rings of @p shared: Chebyshev points of the band of radii that is loaded in @p at_rest and
/// near the terminal spin, at @p expected [rad/s] or at the terminal spin of the load at rest. A failed
/// balance is ignored: the rings at rest are used.
void choose_rings(const Study &study, const std::shared_ptr<ElasticFoot> &shared,
                  const fem::ContactState &at_rest, const std::optional<double> &expected);

} // namespace stemware::pipeline
