#pragma once

#include "ring_model/spin/sample.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace stemware::ring
{

/// Load as a function of one number, such as the spin or the moment ratio.
using LoadFunction = std::function<Sample(double x)>;

/// Costly load with the data that an interpolating curve needs.
struct CurveSource
{
  LoadFunction load;
  std::map<double, Sample> known = {}; ///< samples that are already known, by x
  /// Load that is known everywhere, on the same rings, and close to this load: the difference, which varies
  /// less, is interpolated. Empty: the load itself is interpolated.
  LoadFunction reference = {};
};

/// Tolerance of a curve of a load, over a_0 (RingStack::difference()).
struct CurveTolerance
{
  double wanted = 1e-6;   ///< tolerance with up to `usual_samples`
  double enough = 2e-5;   ///< tolerance with up to four times as many
  double coarsest = 1e-3; ///< tolerance with `max_samples`
  std::size_t usual_samples = 20;
  std::size_t max_samples = 200;
};

/// Piecewise interpolation of a load. Pieces end where the rim lifts off, and where one polynomial would need
/// too many samples.
class SpinCurve
{
public:
  /// Samples @p source on [@p lower, @p upper]. Lift-off points are located first. On each piece, samples are
  /// added at Leja points (or nearby points where the load is known); each new sample measures the error of
  /// the previous polynomial. A piece that needs more than 17 samples is halved. The piece with the largest
  /// error is refined first, until @p tolerance is reached or the samples are used up; error() gives the
  /// result. Afterwards only the reference of @p source is evaluated.
  SpinCurve(const CurveSource &source, double lower, double upper, const CurveTolerance &tolerance = {});

  /// Returns the interpolated load; exact at a sample, constant beyond the first and the last.
  Sample operator()(double x) const;

  std::size_t n_pieces() const { return pieces.size(); }
  /// Ends of the sampled interval.
  double lower() const { return pieces.front().begin; }
  double upper() const { return pieces.back().end; }
  /// Number of samples that were not known beforehand.
  std::size_t n_samples() const { return n_new; }
  /// Bound on the interpolation error, confirmed by the last samples.
  double error() const;
  /// Returns the x at which the rim lifts off, ascending.
  const std::vector<double> &lift_offs() const { return kinks; }

private:
  /// Polynomial in a coordinate in which the load is smooth. At lift-off the load has half powers (or
  /// logarithms) of the distance to the lift-off point; the coordinate is then the square root of that
  /// distance.
  struct Piece
  {
    /// Returns the smooth coordinate, from 0 to 1.
    double coordinate(double x) const;
    /// Returns x at a smooth coordinate, the inverse of coordinate().
    double place(double coordinate) const;
    /// Weights of the nodes' values in the polynomial.
    Eigen::VectorXd weights(double coordinate) const;
    Sample at(double x) const;
    double error() const;
    void add(double x, const Sample &load);

    double begin, end;
    bool kink_at_begin, kink_at_end;
    LoadFunction reference;              ///< CurveSource::reference
    std::map<double, Sample> nodes = {}; ///< by coordinate()
    double estimate = 0;                 ///< estimate of the interpolation error, from the nodes
    unsigned int n_harmonics = 0;
    Eigen::MatrixXd rows = {}; ///< Sample::coefficients() of the nodes minus the reference's
  };

  const Sample &sample(const CurveSource &source, double x);
  /// Finds the points between the known ones at which the rim lifts off or comes back into contact.
  void find_kinks(const CurveSource &source);
  Piece through_ends(const CurveSource &source, double begin, double end, bool kink_at_begin,
                     bool kink_at_end);
  /// Adds a sample at the next Leja point. Its deviation from the previous polynomial measures that
  /// polynomial's error and bounds the new one's.
  void refine(const CurveSource &source, Piece &piece);
  /// Returns the next Leja point (largest product of the distances to all nodes), or a known point whose
  /// product is not much smaller.
  double next_place(const Piece &piece) const;

  std::map<double, Sample> samples; ///< by x
  std::vector<Piece> pieces;        ///< ascending
  std::vector<double> kinks;
  std::size_t n_new = 0; ///< number of new samples
};

} // namespace stemware::ring
