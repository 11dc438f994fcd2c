#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"

#include <memory>
#include <optional>

namespace stemware::pipeline
{

/// Places the rings on which @p shared gathers all its loads: Chebyshev points of the band of radii that
/// carries load in @p at_rest and near the terminal spin, at @p expected [rad/s] or where the load of rest
/// leads to. A failed balance is no failure: the rings of rest are as good as any.
void choose_rings(const Study &study, const std::shared_ptr<ElasticFoot> &shared,
                  const fem::ContactState &at_rest, const std::optional<double> &expected);

} // namespace stemware::pipeline
