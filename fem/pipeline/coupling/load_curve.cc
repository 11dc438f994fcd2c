#include "fem/pipeline/coupling/load_curve.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/interpolators/vector_barycentric_rational.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

// Boost 1.74 has vector_barycentric_rational in boost::math, 1.83 in here.
namespace boost::math::interpolators
{
}

namespace stemware::pipeline
{

namespace
{

using boost::math::double_constants::pi;

/// The polynomial through all samples, whose places are those of a piece's coordinate.
LoadFunction polynomial(const std::map<double, LeaningLoad> &samples)
{
  const std::size_t n_rings = samples.begin()->second.rings().size();
  unsigned int n_harmonics = 0;
  for (const auto &[place, load] : samples)
    n_harmonics = std::max(n_harmonics, load.n_harmonics());
  std::vector<double> x;
  std::vector<std::vector<double>> rows;
  for (const auto &[place, load] : samples)
  {
    x.push_back(place);
    rows.push_back(load.coefficients(n_harmonics));
  }
  const std::size_t width = rows.front().size();
  const std::size_t order = x.size() - 1;
  using namespace boost::math;
  using namespace boost::math::interpolators;
  const vector_barycentric_rational<std::vector<double>, std::vector<std::vector<double>>> curve(
    std::move(x), std::move(rows), order);
  return [curve, width, n_rings](double place)
  {
    std::vector<double> row(width);
    curve(row, place);
    return LeaningLoad::from_coefficients(row, n_rings);
  };
}

/// Chebyshev nodes of [0, 1], ends included; every second one makes a coarser set.
std::vector<double> chebyshev_nodes(unsigned int n_intervals)
{
  std::vector<double> nodes = { 0 };
  for (unsigned int i = 1; i < n_intervals; ++i)
    nodes.push_back((1 - std::cos(pi * i / n_intervals)) / 2);
  nodes.push_back(1);
  return nodes;
}

/// How much of its largest value the error of the polynomial through chebyshev_nodes() shows at @p t.
double visibility(double t, unsigned int n_intervals)
{
  const double angle = std::acos(std::clamp(1 - 2 * t, -1., 1.));
  return std::abs(std::sin(angle) * std::sin(n_intervals * angle));
}

constexpr unsigned int few_intervals = 8, many_intervals = 16;

} // namespace

LoadCurve::Piece::Piece(double begin, double end, bool kink_at_begin, bool kink_at_end)
    : first(begin)
    , last(end)
    , kink_at_first(kink_at_begin)
    , kink_at_last(kink_at_end)
{
}

double LoadCurve::Piece::coordinate(double x) const
{
  const double share = std::clamp((x - first) / (last - first), 0., 1.);
  if (kink_at_first && kink_at_last)
    return std::acos(1 - 2 * share) / pi;
  if (kink_at_first)
    return std::sqrt(share);
  return kink_at_last ? 1 - std::sqrt(1 - share) : share;
}

double LoadCurve::Piece::place(double t) const
{
  if (t == 0 || t == 1)
    return t == 0 ? first : last;
  const double share = kink_at_first && kink_at_last ? (1 - std::cos(pi * t)) / 2
                       : kink_at_first               ? t * t
                       : kink_at_last                ? 1 - (1 - t) * (1 - t)
                                                     : t;
  return first + share * (last - first);
}

std::pair<LoadCurve::Piece, LoadCurve::Piece> LoadCurve::Piece::halves() const
{
  const double middle = place(0.5);
  return { Piece(first, middle, kink_at_first, false), Piece(middle, last, false, kink_at_last) };
}

LoadFunction LoadCurve::interpolate() const
{
  return [pieces = pieces](double x)
  {
    auto part = pieces.begin();
    while (part + 1 != pieces.end() && x > part->piece.end())
      ++part;
    return part->load(part->piece.coordinate(x));
  };
}

double LoadCurve::error() const
{
  double largest = 0;
  for (const Interpolated &part : pieces)
    largest = std::max(largest, part.error);
  return largest;
}

/// Makes a LoadCurve.
class CurveSampler
{
public:
  CurveSampler(const CurveSource &source, double lower, double upper)
      : source(source)
  {
    for (const double x : source.known)
      if (lower < x && x < upper)
        samples.emplace(x, source.load(x));
    for (const double x : { lower, upper })
      sample(x);
    find_kinks();
    std::vector<double> ends = curve.kinks;
    ends.insert(ends.begin(), lower);
    ends.push_back(upper);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      curve.pieces.push_back(
        interpolated({ ends[i], ends[i + 1], i > 0, i + 2 < ends.size() }, few_intervals));
  }

  LoadCurve refined(const CurveTolerance &tolerance)
  {
    const auto worse = [](const LoadCurve::Interpolated &one, const LoadCurve::Interpolated &other)
    { return one.error < other.error; };
    for (;;)
    {
      const auto worst = std::max_element(curve.pieces.begin(), curve.pieces.end(), worse);
      const double allowed = n_new < tolerance.usual_samples       ? tolerance.wanted
                             : n_new < 2 * tolerance.usual_samples ? tolerance.enough
                                                                   : tolerance.coarsest;
      if (worst->error <= allowed || n_new >= tolerance.most_samples)
        break;
      if (worst->n_intervals == few_intervals)
      {
        *worst = interpolated(worst->piece, many_intervals);
        continue;
      }
      const auto [left, right] = worst->piece.halves();
      *worst = interpolated(right, few_intervals);
      curve.pieces.insert(worst, interpolated(left, few_intervals));
    }
    curve.n_sampled = n_new;
    return curve;
  }

private:
  const LeaningLoad &sample(double x)
  {
    const auto known = samples.find(x);
    if (known != samples.end())
      return known->second;
    ++n_new;
    return samples.emplace(x, source.load(x)).first->second;
  }

  double clearance(double x)
  {
    sample(x);
    return source.clearance(x);
  }

  /// Between which of the known places the rim begins to lift off, or stands again, and where.
  void find_kinks()
  {
    if (!source.clearance)
      return;
    std::vector<std::pair<double, double>> known;
    for (const auto &[x, load] : samples)
      known.emplace_back(x, source.clearance(x));
    const double range = known.back().first - known.front().first;
    for (std::size_t i = 0; i + 1 < known.size(); ++i)
    {
      const auto &[left, at_left] = known[i];
      const auto &[right, at_right] = known[i + 1];
      if ((at_left < 0) == (at_right < 0))
        continue;
      // An error d of the place is one of about d^(3/2) of the load.
      constexpr double accuracy = 1e-5;
      std::uintmax_t n_most = 7;
      const auto [below, above] = boost::math::tools::toms748_solve(
        [this](double x) { return clearance(x); }, left, right, at_left, at_right,
        [=](double one, double other) { return std::abs(other - one) < accuracy * range; }, n_most);
      curve.kinks.push_back((below + above) / 2);
    }
  }

  LoadCurve::Interpolated interpolated(const LoadCurve::Piece &piece, unsigned int n_intervals)
  {
    constexpr double safety = 2; // the places of the checks need not be where the error is largest
    constexpr double visible = 0.25, near = 0.12;
    std::map<double, LeaningLoad> nodes;
    for (const double node : chebyshev_nodes(n_intervals))
      nodes.emplace(node, sample(piece.place(node)));
    LoadCurve::Interpolated result = { piece, polynomial(nodes), n_intervals, 0 };
    const auto check = [&](double x)
    {
      const double difference = result.load(piece.coordinate(x)).difference(sample(x));
      result.error = std::max(result.error, safety * difference);
    };
    // In each part of the piece one place, where the load is known if it is somewhere between the nodes.
    std::array<bool, 3> checked = {};
    constexpr std::array<double, 3> wanted = { 0.11, 0.46, 0.81 };
    std::vector<double> known;
    for (const auto &[x, load] : samples)
      if (piece.has_inside(x) && visibility(piece.coordinate(x), n_intervals) > visible)
        known.push_back(x);
    for (const double x : known)
    {
      check(x);
      for (std::size_t i = 0; i < wanted.size(); ++i)
        checked[i] = checked[i] || std::abs(piece.coordinate(x) - wanted[i]) < near;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!checked[i])
        check(piece.place(wanted[i]));
    return result;
  }

  const CurveSource &source;
  std::map<double, LeaningLoad> samples;
  std::size_t n_new = 0; ///< of them, those that were not known
  LoadCurve curve;
};

LoadCurve sample_load_curve(const CurveSource &source, double lower, double upper,
                            const CurveTolerance &tolerance)
{
  return CurveSampler(source, lower, upper).refined(tolerance);
}

} // namespace stemware::pipeline
