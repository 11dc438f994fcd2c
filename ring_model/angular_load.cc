#include "ring_model/angular_load.h"

#include "ring_model/constants.h"
#include "ring_model/require.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Where @p load passes through 0 between two angles at which its signs differ, to 1e-9: what lies on the
/// wrong side then is of the square of that.
double sign_change(const AngularLoad &load, double from, double to)
{
  const bool pulls_at_from = load(from) < 0.;
  while (to - from > 1e-9)
  {
    const double middle = (from + to) / 2.;
    ((load(middle) < 0.) == pulls_at_from ? from : to) = middle;
  }
  return (from + to) / 2.;
}
} // namespace

AngularLoad::AngularLoad(std::vector<double> a, std::vector<double> b, double radius)
    : cosine(std::move(a))
    , sine(std::move(b))
    , ring_radius(radius)
{
  require(!cosine.empty() && cosine.size() == sine.size(), "the load has ", cosine.size(), " cosine and ",
          sine.size(), " sine coefficients, but must have equally many and at least one");
  for (unsigned int n = 0; n < cosine.size(); ++n)
    require(std::isfinite(cosine[n]) && std::isfinite(sine[n]), "harmonic ", n, " of the load is (",
            cosine[n], ", ", sine[n], ") N/rad, but must be finite");
  require(cosine[0] > 0., "the mean load a_0 is ", cosine[0],
          " N/rad, but must be positive: the table pushes the ring up");
  require(sine[0] == 0., "the sine coefficient b_0 is ", sine[0],
          " N/rad, but must be zero: sin 0 has no amplitude");
  require_positive(ring_radius, "the ring radius", "m");
}

AngularLoad AngularLoad::first_harmonic(double normal_force, const Eigen::Vector2d &moment, double radius)
{
  require_positive(normal_force, "the normal force", "N");
  require_positive(radius, "the ring radius", "m");
  return { { normal_force / (2. * pi), -moment.y() / (pi * radius) },
           { 0., moment.x() / (pi * radius) },
           radius };
}

double AngularLoad::normal_force() const
{
  return 2. * pi * cosine[0];
}

Eigen::Vector2d AngularLoad::moment() const
{
  return { pi * ring_radius * b(1), -pi * ring_radius * a(1) };
}

double AngularLoad::moment_ratio() const
{
  return std::hypot(a(1), b(1)) / cosine[0];
}

double AngularLoad::operator()(double theta) const
{
  double sum = cosine[0];
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += cosine[n] * std::cos(n * theta) + sine[n] * std::sin(n * theta);
  return sum;
}

double AngularLoad::derivative(double theta) const
{
  double sum = 0.;
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += n * (sine[n] * std::cos(n * theta) - cosine[n] * std::sin(n * theta));
  return sum;
}

std::vector<double> AngularLoad::evenly_spaced_values() const
{
  // The angles n theta_i are multiples of one spacing: a table of one turn serves all of them.
  const unsigned int n_samples = 32 * n_harmonics();
  const double spacing = 2. * pi / n_samples;
  std::vector<double> cosines(n_samples), sines(n_samples), samples(n_samples, cosine[0]);
  for (unsigned int i = 0; i < n_samples; ++i)
  {
    cosines[i] = std::cos(i * spacing);
    sines[i] = std::sin(i * spacing);
  }
  for (unsigned int n = 1; n < cosine.size(); ++n)
    for (unsigned int i = 0, turn = 0; i < n_samples; ++i, turn = (turn + n) % n_samples)
      samples[i] += cosine[n] * cosines[turn] + sine[n] * sines[turn];
  return samples;
}

std::map<double, double> AngularLoad::local_minima() const
{
  const std::vector<double> samples = evenly_spaced_values();
  const std::size_t n_samples = samples.size();
  const double spacing = 2. * pi / static_cast<double>(n_samples);
  // Half of the digits in theta give all digits of the least value: the slope vanishes there.
  const int bits = std::numeric_limits<double>::digits / 2;
  std::map<double, double> minima;
  for (std::size_t i = 0; i < n_samples; ++i)
    if (samples[i] <= samples[(i + 1) % n_samples] && samples[i] <= samples[(i + n_samples - 1) % n_samples])
    {
      const double middle = static_cast<double>(i) * spacing;
      minima.insert(boost::math::tools::brent_find_minima(*this, middle - spacing, middle + spacing, bits));
      minima.emplace(middle, samples[i]);
    }
  return minima;
}

double AngularLoad::minimum() const
{
  if (n_harmonics() <= 1)
    return cosine[0] - std::hypot(a(1), b(1));
  double least = std::numeric_limits<double>::infinity();
  for (const auto &[theta, value] : local_minima())
    least = std::min(least, value);
  return least;
}

double AngularLoad::integral(double from, double to) const
{
  double sum = cosine[0] * (to - from);
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += (cosine[n] * (std::sin(n * to) - std::sin(n * from)) -
            sine[n] * (std::cos(n * to) - std::cos(n * from))) /
           n;
  return sum;
}

double AngularLoad::pulling_force() const
{
  // The minima are among the angles: a load may be negative between two samples alone.
  const std::vector<double> samples = evenly_spaced_values();
  const double spacing = 2. * pi / static_cast<double>(samples.size());
  std::map<double, double> values = local_minima();
  for (std::size_t i = 0; i < samples.size(); ++i)
    values.emplace(static_cast<double>(i) * spacing, samples[i]);
  double force = 0.;
  for (auto from = values.begin(); from != values.end(); ++from)
  {
    const auto next = std::next(from);
    const double begin = from->first,
                 end = next != values.end() ? next->first : values.begin()->first + 2. * pi;
    const bool pulls_at_begin = from->second < 0.;
    const bool pulls_at_end = (next != values.end() ? next->second : values.begin()->second) < 0.;
    if (!pulls_at_begin && !pulls_at_end)
      continue;
    const double change = pulls_at_begin == pulls_at_end ? end : sign_change(*this, begin, end);
    force -= (pulls_at_begin ? integral(begin, change) : 0.) + (pulls_at_end ? integral(change, end) : 0.);
  }
  return force;
}

AngularLoad AngularLoad::truncated(unsigned int n_max) const
{
  const auto n_kept = static_cast<std::ptrdiff_t>(std::min(n_max, n_harmonics())) + 1;
  return { { cosine.begin(), cosine.begin() + n_kept },
           { sine.begin(), sine.begin() + n_kept },
           ring_radius };
}

AngularLoad AngularLoad::rotated(double angle) const
{
  require_finite(angle, "the angle of rotation");
  std::vector<double> a_turned(cosine), b_turned(sine);
  for (unsigned int n = 1; n < cosine.size(); ++n)
  {
    const double c = std::cos(n * angle), s = std::sin(n * angle);
    a_turned[n] = cosine[n] * c - sine[n] * s;
    b_turned[n] = cosine[n] * s + sine[n] * c;
  }
  return { std::move(a_turned), std::move(b_turned), ring_radius };
}

AngularLoad AngularLoad::mirrored() const
{
  std::vector<double> reversed(sine);
  for (unsigned int n = 1; n < reversed.size(); ++n)
    reversed[n] = -sine[n];
  return { cosine, std::move(reversed), ring_radius };
}
} // namespace stemware::ring
