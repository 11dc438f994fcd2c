#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/response_curve.h"

#include <cstddef>
#include <memory>

namespace stemware::pipeline
{

/// A foot's loads over the moment ratio, from contact solutions.
struct FootResponseCurve
{
  std::shared_ptr<const ring::ResponseCurve> curve;
  double error = 0; ///< bound on its difference from contact solutions that checks have confirmed, over a_0
  std::size_t n_solutions = 0; ///< contact solutions that it took
};

/// Solves the contact of @p foot at moment ratios from 0 to a little above the largest that the moment
/// balance of a first harmonic needs at any spin, until the curve is as good as Load/Response tolerance.
///
/// @p foot must be isotropic. Throws fem::ContactFailure, and std::runtime_error where the tolerance is not
/// reached.
FootResponseCurve measure_response(const Study &study, const ElasticFoot &foot);

} // namespace stemware::pipeline
