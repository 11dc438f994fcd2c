#include "ring_model/spin/spin_curve.h"

#include "ring_model/load/constants.h"
#include "ring_model/load/lagrange.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stemware::ring
{

namespace
{

constexpr std::size_t max_nodes = 17; ///< of a piece

} // namespace

double SpinCurve::Piece::coordinate(double x) const
{
  const double share = std::clamp((x - begin) / (end - begin), 0., 1.);
  if (kink_at_begin && kink_at_end)
    return std::acos(1 - 2 * share) / pi;
  if (kink_at_begin)
    return std::sqrt(share);
  return kink_at_end ? 1 - std::sqrt(1 - share) : share;
}

double SpinCurve::Piece::place(double t) const
{
  if (t == 0 || t == 1)
    return t == 0 ? begin : end;
  const double share = kink_at_begin && kink_at_end ? (1 - std::cos(pi * t)) / 2
                       : kink_at_begin              ? t * t
                       : kink_at_end                ? 1 - (1 - t) * (1 - t)
                                                    : t;
  return begin + share * (end - begin);
}

Eigen::VectorXd SpinCurve::Piece::weights(double t) const
{
  Eigen::VectorXd places(nodes.size());
  std::transform(nodes.begin(), nodes.end(), places.begin(), [](const auto &node) { return node.first; });
  return lagrange_values(places, t);
}

Sample SpinCurve::Piece::at(double x) const
{
  Eigen::VectorXd row = rows * weights(coordinate(x));
  if (reference)
    row += reference(x).coefficients(n_harmonics);
  return Sample::from_coefficients(row, nodes.begin()->second.rings().size());
}

double SpinCurve::Piece::error() const
{
  constexpr std::size_t min_nodes = 4; // of which two have told
  return nodes.size() < min_nodes ? std::numeric_limits<double>::infinity() : estimate;
}

SpinCurve::SpinCurve(const CurveSource &source, double lower, double upper, const CurveTolerance &tolerance)
{
  for (const auto &[x, known] : source.known)
    if (lower < x && x < upper)
      samples.emplace(x, known);
  for (const double x : { lower, upper })
    sample(source, x);
  find_kinks(source);
  std::vector<double> ends = kinks;
  ends.insert(ends.begin(), lower);
  ends.push_back(upper);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    pieces.push_back(through_ends(source, ends[i], ends[i + 1], i > 0, i + 2 < ends.size()));
  while (true)
  {
    const auto worst =
      std::max_element(pieces.begin(), pieces.end(),
                       [](const Piece &one, const Piece &other) { return one.error() < other.error(); });
    const double allowed = n_new < tolerance.usual_samples       ? tolerance.wanted
                           : n_new < 4 * tolerance.usual_samples ? tolerance.enough
                                                                 : tolerance.coarsest;
    if (worst->error() <= allowed || n_new >= tolerance.max_samples)
      return;
    if (worst->nodes.size() < max_nodes)
    {
      refine(source, *worst);
      continue;
    }
    // The two halves in the smooth coordinate.
    const double middle = worst->place(0.5);
    const Piece left = through_ends(source, worst->begin, middle, worst->kink_at_begin, false);
    *worst = through_ends(source, middle, worst->end, false, worst->kink_at_end);
    pieces.insert(worst, left);
  }
}

Sample SpinCurve::operator()(double x) const
{
  if (const auto known = samples.find(x); known != samples.end())
    return known->second;
  auto piece = pieces.begin();
  while (piece + 1 != pieces.end() && x > piece->end)
    ++piece;
  return piece->at(x);
}

double SpinCurve::error() const
{
  double largest = 0;
  for (const Piece &piece : pieces)
    largest = std::max(largest, piece.error());
  return largest;
}

const Sample &SpinCurve::sample(const CurveSource &source, double x)
{
  const auto known = samples.find(x);
  if (known != samples.end())
    return known->second;
  ++n_new;
  return samples.emplace(x, source.load(x)).first->second;
}

void SpinCurve::find_kinks(const CurveSource &source)
{
  std::vector<std::pair<double, double>> known;
  for (const auto &[x, load] : samples)
    known.emplace_back(x, load.lift_off_margin);
  const double range = known.back().first - known.front().first;
  for (std::size_t i = 0; i + 1 < known.size(); ++i)
  {
    const auto &[left, at_left] = known[i];
    const auto &[right, at_right] = known[i + 1];
    if ((at_left < 0) == (at_right < 0))
      continue;
    const auto lift_off_margin = [&](double x) { return sample(source, x).lift_off_margin; };
    // An error d of the place is one of about d^(3/2) of the load.
    constexpr double accuracy = 1e-5;
    std::uintmax_t n_most = 7;
    const auto [below, above] = boost::math::tools::toms748_solve(
      lift_off_margin, left, right, at_left, at_right,
      [=](double one, double other) { return std::abs(other - one) < accuracy * range; }, n_most);
    kinks.push_back((below + above) / 2);
  }
}

SpinCurve::Piece SpinCurve::through_ends(const CurveSource &source, double begin, double end,
                                         bool kink_at_begin, bool kink_at_end)
{
  Piece piece = { begin, end, kink_at_begin, kink_at_end, source.reference };
  for (const double x : { begin, end })
    piece.add(x, sample(source, x));
  return piece;
}

void SpinCurve::Piece::add(double x, const Sample &load)
{
  nodes.emplace(coordinate(x), load);
  n_harmonics = std::max(n_harmonics, load.n_harmonics());
  Eigen::Index k = 0;
  for (const auto &[node, load_there] : nodes)
  {
    Eigen::VectorXd row = load_there.coefficients(n_harmonics);
    if (reference)
      row -= reference(place(node)).coefficients(n_harmonics);
    rows.conservativeResize(row.size(), static_cast<Eigen::Index>(nodes.size()));
    rows.col(k++) = row;
  }
}

void SpinCurve::refine(const CurveSource &source, Piece &piece)
{
  constexpr double safety = 2;      // the error need not be largest there
  constexpr double usual_gain = 10; // of one sample: what falls faster may have been close by chance
  const double x = next_place(piece);
  const Sample &load = sample(source, x);
  const double miss = safety * piece.at(x).difference(load);
  piece.estimate = std::max(miss, piece.estimate / usual_gain);
  piece.add(x, load);
}

double SpinCurve::next_place(const Piece &piece) const
{
  constexpr unsigned int n_places = 128;
  constexpr double known_counts = 3;
  double best = 0, most = 0;
  const auto compare = [&](double x, double coordinate, double weight)
  {
    double product = weight;
    for (const auto &[node, load] : piece.nodes)
      product *= std::abs(coordinate - node);
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
  for (const auto &[x, load] : samples)
    if (piece.begin < x && x < piece.end)
      compare(x, piece.coordinate(x), known_counts);
  return best;
}

} // namespace stemware::ring
