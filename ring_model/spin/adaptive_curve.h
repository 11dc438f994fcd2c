#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace stemware::ring
{
/// Costly function of a number x to be interpolated, such as the load by spin.
struct CurveSource
{
  std::function<Eigen::VectorXd(double x)> value;
  /// Returns the error of an interpolated value at x, to be compared with CurveTolerance.
  std::function<double(double x, const Eigen::VectorXd &interpolated, const Eigen::VectorXd &exact)> error;
  std::vector<double> cached = {}; ///< x with a cached value()
  /// x at which the function has a half power (or a logarithm) of the distance, ascending.
  std::vector<double> kinks = {};
};

/// Tolerance of a curve, in the unit of CurveSource::error.
struct CurveTolerance
{
  double target = 1e-6;  ///< with fewer than `usual_samples`
  double relaxed = 2e-5; ///< with more samples
  std::size_t usual_samples = 20;
  std::size_t max_samples = 80;
};

/// Piecewise polynomial interpolation of a costly function, with its error. Pieces end at kinks, and wherever
/// one polynomial would need too many samples.
class AdaptiveCurve
{
public:
  /// Samples @p source on [@p lower, @p upper]. Samples are added at Leja points (or cached points nearby) of
  /// the piece with the largest error, measured by the last sample, until @p tolerance is reached or the
  /// samples are used up. A piece that needs more than 17 samples is halved. @p source is not kept.
  AdaptiveCurve(const CurveSource &source, double lower, double upper, const CurveTolerance &tolerance = {});

  /// Returns the interpolated value; exact at the nodes, constant beyond the ends.
  Eigen::VectorXd operator()(double x) const;

  std::size_t n_pieces() const;
  /// Returns the end of the sampled interval.
  double upper() const { return end; }
  bool covers(double x) const { return begin <= x && x <= end; }
  /// Returns the number of samples without cached values.
  std::size_t n_samples() const { return n_new; }
  /// Returns a bound on the interpolation error, confirmed by the last samples.
  double error() const;

private:
  struct Piece;
  class Sampling;

  double begin, end;
  std::shared_ptr<const std::vector<Piece>> pieces; ///< ascending
  std::size_t n_new = 0;                            ///< number of new samples
};
} // namespace stemware::ring
