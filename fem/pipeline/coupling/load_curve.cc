#include "fem/pipeline/coupling/load_curve.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/interpolators/vector_barycentric_rational.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

// Boost 1.74 has vector_barycentric_rational in boost::math, 1.83 in here.
namespace boost::math::interpolators
{
}

namespace stemware::pipeline
{

namespace
{

using boost::math::double_constants::pi;

/// Adds @p factor times the coefficients of @p load to @p row, which has those up to @p n_harmonics.
void add(double factor, const LeaningLoad &load, unsigned int n_harmonics, std::vector<double> &row)
{
  const std::vector<double> other = load.truncated(n_harmonics).coefficients(n_harmonics);
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] += factor * other[i];
}

constexpr std::size_t most_nodes = 17; ///< of a piece

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
    return part->load(x);
  };
}

double LoadCurve::Interpolated::error() const
{
  constexpr std::size_t least_nodes = 4; // of which two have told
  return nodes.size() < least_nodes ? std::numeric_limits<double>::infinity() : estimate;
}

void LoadCurve::Interpolated::interpolate()
{
  unsigned int n_harmonics = 0;
  for (const auto &[node, load] : nodes)
    n_harmonics = std::max(n_harmonics, load.n_harmonics());
  std::vector<double> x;
  std::vector<std::vector<double>> rows;
  for (const auto &[node, load] : nodes)
  {
    x.push_back(node);
    rows.push_back(load.coefficients(n_harmonics));
    if (reference)
      add(-1, reference(piece.place(node)), n_harmonics, rows.back());
  }
  const std::size_t width = rows.front().size(), order = x.size() - 1;
  const std::size_t n_rings = nodes.begin()->second.rings().size();
  using namespace boost::math;
  using namespace boost::math::interpolators;
  const auto curve = std::make_shared<
    const vector_barycentric_rational<std::vector<double>, std::vector<std::vector<double>>>>(
    std::move(x), std::move(rows), order);
  load = [=, piece = piece, reference = reference](double place)
  {
    std::vector<double> row(width);
    (*curve)(row, piece.coordinate(place));
    if (reference)
      add(1, reference(place), n_harmonics, row);
    return LeaningLoad::from_coefficients(row, n_rings);
  };
}

double LoadCurve::error() const
{
  double largest = 0;
  for (const Interpolated &part : pieces)
    largest = std::max(largest, part.error());
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
      curve.pieces.push_back(through_ends({ ends[i], ends[i + 1], i > 0, i + 2 < ends.size() }));
  }

  LoadCurve refined(const CurveTolerance &tolerance)
  {
    const auto worse = [](const LoadCurve::Interpolated &one, const LoadCurve::Interpolated &other)
    { return one.error() < other.error(); };
    for (;;)
    {
      const auto worst = std::max_element(curve.pieces.begin(), curve.pieces.end(), worse);
      const double allowed = n_new < tolerance.usual_samples       ? tolerance.wanted
                             : n_new < 2 * tolerance.usual_samples ? tolerance.enough
                                                                   : tolerance.coarsest;
      if (worst->error() <= allowed || n_new >= tolerance.most_samples)
        break;
      if (worst->nodes.size() < most_nodes)
      {
        add_node(*worst);
        continue;
      }
      const auto [left, right] = worst->piece.halves();
      *worst = through_ends(right);
      curve.pieces.insert(worst, through_ends(left));
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

  LoadCurve::Interpolated through_ends(const LoadCurve::Piece &piece)
  {
    LoadCurve::Interpolated part = { piece, {}, source.reference, {} };
    for (const double node : { 0., 1. })
      part.nodes.emplace(node, sample(piece.place(node)));
    part.interpolate();
    return part;
  }

  /// Adds a sample where the polynomial through the others is worst known: what it is off by there tells its
  /// error, and bounds that of the polynomial through all.
  void add_node(LoadCurve::Interpolated &part)
  {
    constexpr double safety = 2;      // the error need not be largest there
    constexpr double usual_gain = 10; // of one sample: what falls faster may have been close by chance
    const double x = next_place(part);
    const LeaningLoad &load = sample(x);
    const double miss = safety * part.load(x).difference(load);
    part.estimate = std::max(miss, part.estimate / usual_gain);
    part.nodes.emplace(part.piece.coordinate(x), load);
    part.interpolate();
  }

  /// Where the product of the distances to all nodes is largest (Leja's points), or a place where the load is
  /// known and that product is not much smaller.
  double next_place(const LoadCurve::Interpolated &part) const
  {
    constexpr unsigned int n_places = 128;
    constexpr double known_counts = 3;
    double best = 0, most = 0;
    const auto compare = [&](double x, double coordinate, double weight)
    {
      double product = weight;
      for (const auto &[node, load] : part.nodes)
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
      compare(part.piece.place(coordinate), coordinate, 1);
    }
    for (const auto &[x, load] : samples)
      if (part.piece.has_inside(x))
        compare(x, part.piece.coordinate(x), known_counts);
    return best;
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
