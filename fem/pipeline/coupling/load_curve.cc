#include "fem/pipeline/coupling/load_curve.h"

#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/interpolators/vector_barycentric_rational.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Boost 1.74 has vector_barycentric_rational in boost::math, 1.83 in here.
namespace boost::math::interpolators
{
}

namespace stemware::pipeline
{

namespace
{

/// The polynomial through all samples.
LoadFunction polynomial(const LoadSamples &samples)
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

/// Chebyshev nodes of [lower, upper], ends included; every second one makes a coarser set.
std::vector<double> chebyshev_nodes(double lower, double upper, unsigned int n_intervals)
{
  std::vector<double> nodes = { lower };
  for (unsigned int i = 1; i < n_intervals; ++i)
    nodes.push_back((lower + upper) / 2 -
                    (upper - lower) / 2 * std::cos(boost::math::constants::pi<double>() * i / n_intervals));
  nodes.push_back(upper);
  return nodes;
}

} // namespace

LoadFunction LoadCurve::interpolate() const
{
  std::map<double, LoadFunction> curves; // by the end of the piece
  for (const LoadSamples &piece : pieces)
    curves.emplace(piece.rbegin()->first, polynomial(piece));
  return [curves](double x)
  {
    const auto piece = curves.lower_bound(x);
    return piece == curves.end() ? curves.rbegin()->second(x) : piece->second(x);
  };
}

LoadCurve sample_load_curve(const LoadFunction &exact, double lower, double upper, double tolerance,
                            std::size_t most_samples)
{
  constexpr double safety = 2; // the three places need not be where the error is largest
  LoadCurve curve;
  LoadSamples known;
  const auto sample = [&](double x)
  {
    const auto found = known.find(x);
    return found != known.end() ? found->second : known.emplace(x, exact(x)).first->second;
  };
  std::vector<std::pair<double, double>> open = { { lower, upper } }; // the last is the leftmost
  while (!open.empty())
  {
    const auto [begin, end] = open.back();
    open.pop_back();
    double difference = 0;
    LoadSamples samples;
    for (const unsigned int n_intervals : { 8u, 16u })
    {
      samples.clear();
      for (const double node : chebyshev_nodes(begin, end, n_intervals))
        samples.emplace(node, sample(node));
      // Between nodes, where the error of such a polynomial is largest; not at the nodes of the finer set.
      const LoadFunction inside = polynomial(samples);
      difference = 0;
      for (const double share : { 0.05, 0.46, 0.81 })
      {
        const double x = begin + share * (end - begin);
        difference = std::max(difference, safety * inside(x).difference(sample(x)));
      }
      if (difference <= tolerance)
        break;
    }
    if (difference <= tolerance)
    {
      curve.error = std::max(curve.error, difference);
      curve.pieces.push_back(std::move(samples));
      continue;
    }
    if (known.size() >= most_samples)
      throw ToleranceMissed("an interpolated curve through " + std::to_string(known.size()) +
                            " loads still misses the load by " + to_short_text(difference) +
                            " of a_0, where " + to_short_text(tolerance) + " is asked for");
    open.emplace_back((begin + end) / 2, end);
    open.emplace_back(begin, (begin + end) / 2);
  }
  curve.n_samples = known.size();
  return curve;
}

} // namespace stemware::pipeline
