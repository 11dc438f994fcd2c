#include "ring_model/spin/adaptive_curve.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::ring
{
double AdaptiveCurve::Piece::coordinate(double x) const
{
  const double share = std::clamp((x - begin) / (end - begin), 0., 1.);
  if (kink_at_begin && kink_at_end)
    return std::acos(1 - 2 * share) / pi;
  if (kink_at_begin)
    return std::sqrt(share);
  return kink_at_end ? 1 - std::sqrt(1 - share) : share;
}

double AdaptiveCurve::Piece::place(double t) const
{
  if (t == 0 || t == 1)
    return t == 0 ? begin : end;
  const double share = kink_at_begin && kink_at_end ? (1 - std::cos(pi * t)) / 2
                       : kink_at_begin              ? t * t
                       : kink_at_end                ? 1 - (1 - t) * (1 - t)
                                                    : t;
  return begin + share * (end - begin);
}

Eigen::VectorXd AdaptiveCurve::Piece::at(double x) const
{
  const Eigen::ArrayXd distances = coordinate(x) - nodes;
  Eigen::Index nearest = 0;
  if (distances.abs().minCoeff(&nearest) == 0)
    return values.col(nearest);
  const Eigen::ArrayXd weights = barycentric / distances;
  return values * (weights / weights.sum()).matrix();
}

double AdaptiveCurve::Piece::error() const
{
  constexpr Eigen::Index min_nodes = 4; // the error estimate requires the two ends and two added nodes
  return nodes.size() < min_nodes ? std::numeric_limits<double>::infinity() : estimate;
}

void AdaptiveCurve::Piece::add(double x, const Eigen::VectorXd &value)
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

AdaptiveCurve::AdaptiveCurve(const CurveSource &source, double lower, double upper,
                             const CurveTolerance &tolerance)
{
  constexpr Eigen::Index max_nodes = 17; // per piece
  constexpr std::size_t samples_for_halves = 5;
  for (const double x : source.cached)
    if (lower < x && x < upper)
      samples.emplace(x, source.value(x));
  std::vector<double> ends = source.kinks;
  ends.insert(ends.begin(), lower);
  ends.push_back(upper);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    pieces.push_back(through_ends(source, ends[i], ends[i + 1], i > 0, i + 2 < ends.size()));
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
      refine(source, *worst);
      continue;
    }
    const double middle = worst->place(0.5);
    const Piece left = through_ends(source, worst->begin, middle, worst->kink_at_begin, false);
    *worst = through_ends(source, middle, worst->end, false, worst->kink_at_end);
    pieces.insert(worst, left);
  }
}

Eigen::VectorXd AdaptiveCurve::operator()(double x) const
{
  auto piece = pieces.begin();
  while (piece + 1 != pieces.end() && x > piece->end)
    ++piece;
  return piece->at(x);
}

double AdaptiveCurve::error() const
{
  double largest = 0;
  for (const Piece &piece : pieces)
    largest = std::max(largest, piece.error());
  return largest;
}

const Eigen::VectorXd &AdaptiveCurve::sample(const CurveSource &source, double x)
{
  const auto known = samples.find(x);
  if (known != samples.end())
    return known->second;
  ++n_new;
  return samples.emplace(x, source.value(x)).first->second;
}

AdaptiveCurve::Piece AdaptiveCurve::through_ends(const CurveSource &source, double begin, double end,
                                                 bool kink_at_begin, bool kink_at_end)
{
  Piece piece = { begin, end, kink_at_begin, kink_at_end };
  for (const double x : { begin, end })
    piece.add(x, sample(source, x));
  return piece;
}

void AdaptiveCurve::refine(const CurveSource &source, Piece &piece)
{
  constexpr double safety = 2; // the error may be larger at other points
  // Maximum factor by which one sample reduces the error estimate; a larger reduction may be accidental.
  constexpr double usual_gain = 10;
  const double x = next_place(piece);
  const Eigen::VectorXd &exact = sample(source, x);
  piece.estimate = std::max(safety * source.error(x, piece.at(x), exact), piece.estimate / usual_gain);
  piece.add(x, exact);
}

double AdaptiveCurve::next_place(const Piece &piece) const
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
} // namespace stemware::ring
