#pragma once

#include "fem/pipeline/coupling/leaning_load.h"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace stemware::pipeline
{

/// A load that depends on one number, such as the spin or the moment ratio.
using LoadFunction = std::function<LeaningLoad(double x)>;

/// A load that is costly to find, and what a curve of it has to know.
struct CurveSource
{
  LoadFunction load;
  /// Positive where the rim carries load all round, negative where it has lifted off in part; changes sign
  /// where it begins to. Asked only where the load is known. Empty: the rim never lifts off.
  std::function<double(double x)> clearance = {};
  std::vector<double> known = {}; ///< where the load costs nothing, ascending
  /// A load that is known everywhere and differs from this one by less than that varies, of the same rings:
  /// the difference is interpolated. Empty: the load itself is.
  LoadFunction reference = {};
};

/// How well a curve is to know a load, over a_0 (RingStack::difference()).
struct CurveTolerance
{
  double wanted = 1e-6;   ///< with up to `usual_samples`
  double enough = 2e-5;   ///< with up to twice as many
  double coarsest = 2e-5; ///< with `most_samples`
  std::size_t usual_samples = 20;
  std::size_t most_samples = 200;
};

/// Samples from which a load can be interpolated, piece by piece: a new piece begins where the rim lifts off,
/// and where one polynomial would need too many.
class LoadCurve
{
public:
  /// One polynomial, in a coordinate in which the load is smooth. Where a rim lifts off, a load has half
  /// powers of the distance to that place, or logarithms: towards it the coordinate is the root of the
  /// distance.
  class Piece
  {
  public:
    /// Between @p begin and @p end; @p kink_at_begin and @p kink_at_end: whether the rim lifts off there, or
    /// stands again.
    Piece(double begin, double end, bool kink_at_begin, bool kink_at_end);

    double end() const { return last; }
    bool has_inside(double x) const { return first < x && x < last; }

    /// Its smooth coordinate, from 0 to 1.
    double coordinate(double x) const;
    /// The inverse of coordinate().
    double place(double coordinate) const;
    /// The two halves in the smooth coordinate.
    std::pair<Piece, Piece> halves() const;

  private:
    double first, last;
    bool kink_at_first, kink_at_last;
  };

  /// The load between the samples; from the first sample to the last.
  LoadFunction interpolate() const;

  std::size_t n_pieces() const { return pieces.size(); }
  std::size_t n_samples() const { return n_sampled; }
  /// Bound on the interpolation's error that checks have confirmed, see RingStack::difference().
  double error() const;
  /// Where the rim lifts off, ascending.
  const std::vector<double> &lift_offs() const { return kinks; }

private:
  friend class CurveSampler;
  /// The polynomial through its nodes, made anew with each of them.
  struct Interpolated
  {
    void interpolate();
    double error() const;

    Piece piece;
    std::map<double, LeaningLoad> nodes; ///< by the piece's coordinate
    LoadFunction reference;              ///< CurveSource::reference
    LoadFunction load;                   ///< between the nodes
    double estimate = 0;                 ///< of its error, by what its nodes have told
  };
  std::vector<Interpolated> pieces; ///< ascending
  std::vector<double> kinks;
  std::size_t n_sampled = 0;
};

/// Samples @p source on [@p lower, @p upper]. Where the rim begins to lift off is found first. The polynomial
/// on each piece is given sample after sample at Leja's points (or next to them, where the load is known),
/// each of which tells the error of the polynomial before it; a piece for which 17 do not do is halved. The
/// worst piece comes first, until @p tolerance is reached or the samples are used up: error() tells.
LoadCurve sample_load_curve(const CurveSource &source, double lower, double upper,
                            const CurveTolerance &tolerance = {});

} // namespace stemware::pipeline
