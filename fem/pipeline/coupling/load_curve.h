#pragma once

#include "fem/pipeline/coupling/leaning_load.h"

#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

namespace stemware::pipeline
{

/// A load that depends on one number, such as the spin or the moment ratio.
using LoadFunction = std::function<LeaningLoad(double x)>;

/// Loads at some x.
using LoadSamples = std::map<double, LeaningLoad>;

/// Samples from which a load can be interpolated, piece by piece: at the ends of one piece the next one
/// begins.
struct LoadCurve
{
  std::vector<LoadSamples> pieces;
  double error =
    0; ///< bound on the interpolation's error that checks have confirmed, see RingStack::difference()
  std::size_t n_samples = 0; ///< loads that were computed

  /// The load between the samples, one polynomial for each piece; from the first sample to the last.
  LoadFunction interpolate() const;
};

/// Thrown when a curve does not reach its tolerance; what() says what it reached, without a full stop.
class ToleranceMissed : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Samples @p exact on [@p lower, @p upper] at Chebyshev nodes. On each piece the polynomial through 9 nodes,
/// then that through 17, is checked at three places between them; where it still differs by more than @p
/// tolerance the piece is halved.
///
/// Throws ToleranceMissed when @p most_samples do not do.
LoadCurve sample_load_curve(const LoadFunction &exact, double lower, double upper, double tolerance,
                            std::size_t most_samples);

} // namespace stemware::pipeline
