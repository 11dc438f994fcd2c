#include "ring_model/spin/adaptive_curve.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace stemware::ring
{
/// Polynomial in a smooth coordinate: next to a kink, the square root of the distance to it.
struct AdaptiveCurve::Piece
{
  /// Returns the smooth coordinate, from 0 to 1.
  double coordinate(double x) const
  {
    const double share = std::clamp((x - begin) / (end - begin), 0., 1.);
    if (kink_at_begin && kink_at_end)
      return std::acos(1 - 2 * share) / pi;
    if (kink_at_begin)
      return std::sqrt(share);
    return kink_at_end ? 1 - std::sqrt(1 - share) : share;
  }

  /// Returns x at a smooth coordinate, the inverse of coordinate().
  double place(double t) const
  {
    if (t == 0 || t == 1)
      return t == 0 ? begin : end;
    const double share = kink_at_begin && kink_at_end ? (1 - std::cos(pi * t)) / 2
                         : kink_at_begin              ? t * t
                         : kink_at_end                ? 1 - (1 - t) * (1 - t)
                                                      : t;
    return begin + share * (end - begin);
  }

  Eigen::VectorXd at(double x) const
  {
    const Eigen::ArrayXd distances = coordinate(x) - nodes;
    Eigen::Index nearest = 0;
    if (distances.abs().minCoeff(&nearest) == 0)
      return values.col(nearest);
    const Eigen::ArrayXd weights = barycentric / distances;
    return values * (weights / weights.sum()).matrix();
  }

  double error() const
  {
    constexpr Eigen::Index min_nodes = 4; // the error estimate requires the two ends and two added nodes
    return nodes.size() < min_nodes ? std::numeric_limits<double>::infinity() : estimate;
  }

  void add(double x, const Eigen::VectorXd &value)
  {
    const Eigen::Index n = nodes.size();
    const Eigen::ArrayXd distances = coordinate(x) - nodes;
    barycentric /= -distances;
    for (Eigen::ArrayXd *list : { &nodes, &barycentric })
      list->conservativeResize(n + 1);
    nodes(n) = coordinate(x);
    barycentric(n) = 1 / distances.prod();
    values.conservativeResize(value.size(), n + 1);
    values.col(n) = value;
  }

  double begin, end;
  bool kink_at_begin, kink_at_end;
  double estimate = 0;             ///< estimate of the interpolation error, from the nodes
  Eigen::ArrayXd nodes = {};       ///< coordinates of the samples
  Eigen::ArrayXd barycentric = {}; ///< weights of the nodes in the barycentric formula
  Eigen::MatrixXd values = {};     ///< shape [size of a value, number of nodes]
};

/// Samples of a source, and the pieces through them.
class AdaptiveCurve::Sampling
{
public:
  Sampling(const CurveSource &source, double lower, double upper)
      : source(source)
  {
    for (const double x : source.cached)
      if (lower < x && x < upper)
        samples.emplace(x, source.value(x));
    std::vector<double> ends = source.kinks;
    ends.insert(ends.begin(), lower);
    ends.push_back(upper);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      pieces.push_back(through_ends(ends[i], ends[i + 1], i > 0, i + 2 < ends.size()));
  }

  /// Adds samples until @p tolerance is reached or the samples are used up.
  void refine(const CurveTolerance &tolerance)
  {
    constexpr Eigen::Index max_nodes = 17; // per piece
    constexpr std::size_t samples_for_halves = 5;
    while (true)
    {
      const auto worst =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Piece &one, const Piece &other) { return one.error() < other.error(); });
      const double allowed = n_new < tolerance.usual_samples ? tolerance.target : tolerance.relaxed;
      if (worst->error() <= allowed || n_new >= tolerance.max_samples)
        return;
      // Both halves of a piece need enough new samples for their error estimates.
      if (worst->nodes.size() < max_nodes || n_new + samples_for_halves > tolerance.max_samples)
      {
        add_sample(*worst);
        continue;
      }
      const double middle = worst->place(0.5);
      const Piece left = through_ends(worst->begin, middle, worst->kink_at_begin, false);
      *worst = through_ends(middle, worst->end, false, worst->kink_at_end);
      pieces.insert(worst, left);
    }
  }

  std::vector<Piece> pieces;
  std::size_t n_new = 0;

private:
  const Eigen::VectorXd &sample(double x)
  {
    const auto known = samples.find(x);
    if (known != samples.end())
      return known->second;
    ++n_new;
    return samples.emplace(x, source.value(x)).first->second;
  }

  Piece through_ends(double begin, double end, bool kink_at_begin, bool kink_at_end)
  {
    Piece piece = { begin, end, kink_at_begin, kink_at_end };
    for (const double x : { begin, end })
      piece.add(x, sample(x));
    return piece;
  }

  /// Adds a sample at the next Leja point; it measures the error of the previous polynomial.
  void add_sample(Piece &piece)
  {
    constexpr double safety = 2; // the error may be larger at other points
    // Maximum factor by which one sample reduces the error estimate; a larger reduction may be accidental.
    constexpr double usual_gain = 10;
    const double x = next_place(piece);
    const Eigen::VectorXd &exact = sample(x);
    piece.estimate = std::max(safety * source.error(x, piece.at(x), exact), piece.estimate / usual_gain);
    piece.add(x, exact);
  }

  /// Returns the next Leja point (largest product of distances to all nodes), or a good cached point.
  double next_place(const Piece &piece) const
  {
    constexpr unsigned int n_places = 128;
    constexpr double known_counts = 3;
    double best = 0, most = 0;
    const auto compare = [&](double x, double coordinate, double weight)
    {
      const double product = weight * (coordinate - piece.nodes).abs().prod();
      if (product > most)
      {
        most = product;
        best = x;
      }
    };
    for (unsigned int i = 1; i < n_places; ++i)
    {
      const double coordinate = (1 - std::cos(pi * i / n_places)) / 2;
      compare(piece.place(coordinate), coordinate, 1);
    }
    for (const auto &[x, value] : samples)
      if (piece.begin < x && x < piece.end)
        compare(x, piece.coordinate(x), known_counts);
    return best;
  }

  const CurveSource &source;
  std::map<double, Eigen::VectorXd> samples; ///< samples by x
};

AdaptiveCurve::AdaptiveCurve(const CurveSource &source, double lower, double upper,
                             const CurveTolerance &tolerance)
    : begin(lower)
    , end(upper)
{
  Sampling sampling(source, lower, upper);
  sampling.refine(tolerance);
  n_new = sampling.n_new;
  pieces = std::make_shared<const std::vector<Piece>>(std::move(sampling.pieces));
}

Eigen::VectorXd AdaptiveCurve::operator()(double x) const
{
  auto piece = pieces->begin();
  while (piece + 1 != pieces->end() && x > piece->end)
    ++piece;
  return piece->at(x);
}

std::size_t AdaptiveCurve::n_pieces() const
{
  return pieces->size();
}

double AdaptiveCurve::error() const
{
  double largest = 0;
  for (const Piece &piece : *pieces)
    largest = std::max(largest, piece.error());
  return largest;
}
} // namespace stemware::ring
