#pragma once

#include "ring_model/spin/leaning_load.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace stemware::ring
{

/// A load that depends on one number, such as the spin or the moment ratio.
using LoadFunction = std::function<LeaningLoad(double x)>;

/// A load that is costly to find, and what a curve of it has to know.
struct CurveSource
{
  LoadFunction load;
  /// Positive where the rim carries load all round, negative where it has lifted off in part; changes sign
  /// where it begins to. Asked only where the load is known. Empty: the rim never lifts off.
  std::function<double(double x)> lift_off_margin = {};
  std::vector<double> known = {}; ///< where the load costs nothing, ascending
  /// A load that is known everywhere and differs from this one by less than that varies, of the same rings:
  /// the difference is interpolated. Empty: the load itself is.
  LoadFunction reference = {};
};

/// Tolerance of a curve of a load, over a_0 (RingStack::difference()).
struct CurveTolerance
{
  double wanted = 1e-6;   ///< with up to `usual_samples`
  double enough = 2e-5;   ///< with up to four times as many
  double coarsest = 1e-3; ///< with `max_samples`
  std::size_t usual_samples = 20;
  std::size_t max_samples = 200;
};

/// A load interpolated between samples, piece by piece: a new piece begins where the rim lifts off, and where
/// one polynomial would need too many.
class SpinCurve
{
public:
  /// Samples @p source on [@p lower, @p upper]. Where the rim begins to lift off is found first. The
  /// polynomial on each piece is given sample after sample at Leja's points (or next to them, where the load
  /// is known), each of which tells the error of the polynomial before it; a piece for which 17 do not do is
  /// halved. The worst piece comes first, until @p tolerance is reached or the samples are used up: error()
  /// tells. @p source is not asked afterwards, but for its reference.
  SpinCurve(const CurveSource &source, double lower, double upper, const CurveTolerance &tolerance = {});

  /// The load between the samples, at a sample the very load, and beyond the first and the last as there.
  LeaningLoad operator()(double x) const;

  std::size_t n_pieces() const { return pieces.size(); }
  /// Samples that were not known.
  std::size_t n_samples() const { return n_new; }
  /// Bound on the interpolation's error that checks have confirmed.
  double error() const;
  /// Returns the places at which the rim lifts off, ascending.
  const std::vector<double> &lift_offs() const { return kinks; }

private:
  /// One polynomial, in a coordinate in which the load is smooth. Where a rim lifts off, or stands again, a
  /// load has half powers of the distance to that place, or logarithms: towards it the coordinate is the root
  /// of the distance.
  struct Piece
  {
    /// Returns the smooth coordinate, from 0 to 1.
    double coordinate(double x) const;
    /// The inverse of coordinate().
    double place(double coordinate) const;
    /// Weights of the nodes' values in the polynomial.
    Eigen::VectorXd weights(double coordinate) const;
    LeaningLoad at(double x) const;
    double error() const;
    void add(double x, const LeaningLoad &load);

    double begin, end;
    bool kink_at_begin, kink_at_end;
    LoadFunction reference;                   ///< CurveSource::reference
    std::map<double, LeaningLoad> nodes = {}; ///< by coordinate()
    double estimate = 0;                      ///< of its error, by what its nodes have told
    unsigned int n_harmonics = 0;
    Eigen::MatrixXd rows = {}; ///< LeaningLoad::coefficients() of the nodes, less those of the reference
  };

  const LeaningLoad &sample(const CurveSource &source, double x);
  /// Finds the places at which the rim begins to lift off, or stands again, between the known ones.
  void find_kinks(const CurveSource &source);
  Piece through_ends(const CurveSource &source, double begin, double end, bool kink_at_begin,
                     bool kink_at_end);
  /// Adds a sample where the polynomial through the others is worst known: what it is off by there tells its
  /// error, and bounds that of the polynomial through all.
  void refine(const CurveSource &source, Piece &piece);
  /// Returns the place of the largest product of the distances to all nodes (Leja's points), or one at which
  /// the load is known and that product is not much smaller.
  double next_place(const Piece &piece) const;

  std::map<double, LeaningLoad> samples; ///< by x
  std::vector<Piece> pieces;             ///< ascending
  std::vector<double> kinks;
  std::size_t n_new = 0; ///< of the samples
};

} // namespace stemware::ring
