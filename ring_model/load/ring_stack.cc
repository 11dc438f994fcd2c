#include "ring_model/load/ring_stack.h"

#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Returns the angle between @p from and @p to at which @p function changes sign, to 1e-9 rad. The integrals
/// and extrema computed with this angle are stationary at the exact angle, so their error is of second order.
template <typename Function>
double sign_change(const Function &function, double from, double to)
{
  const bool is_negative_at_from = function(from) < 0.;
  while (to - from > 1e-9)
  {
    const double middle = (from + to) / 2.;
    ((function(middle) < 0.) == is_negative_at_from ? from : to) = middle;
  }
  return (from + to) / 2.;
}
} // namespace

RingStack::RingStack(std::vector<Ring> rings)
    : stack(std::move(rings))
{
  require(!stack.empty(), "the load has no ring; give at least one");
  const std::size_t n_coefficients = stack.front().a.size();
  cosine.assign(n_coefficients, 0.);
  sine.assign(n_coefficients, 0.);
  for (const Ring &ring : stack)
  {
    require(!ring.a.empty() && ring.a.size() == ring.b.size(), "the load has ", ring.a.size(), " cosine and ",
            ring.b.size(), " sine coefficients, but must have equally many and at least one");
    require(ring.a.size() == n_coefficients, "one ring of the load has ", ring.a.size(),
            " coefficients, another ", n_coefficients, "; give all rings equally many");
    for (std::size_t n = 0; n < n_coefficients; ++n)
    {
      require(std::isfinite(ring.a[n]) && std::isfinite(ring.b[n]), "harmonic ", n, " of the load is (",
              ring.a[n], ", ", ring.b[n], ") N/rad, but must be finite");
      cosine[n] += ring.a[n];
      sine[n] += ring.b[n];
    }
    require(ring.b[0] == 0., "the sine coefficient b_0 is ", ring.b[0],
            " N/rad, but must be zero: sin 0 has no amplitude");
    require_positive(ring.radius, "the ring radius", "m");
  }
  require(cosine[0] > 0., "the mean load a_0 is ", cosine[0],
          " N/rad, but must be positive: the table pushes the ring up");
}

RingStack::RingStack(std::vector<double> a, std::vector<double> b, double radius)
    : RingStack(std::vector<Ring>{ { radius, std::move(a), std::move(b) } })
{
}

RingStack RingStack::first_harmonic(double normal_force, const Eigen::Vector2d &moment, double radius)
{
  require_positive(normal_force, "the normal force", "N");
  require_positive(radius, "the ring radius", "m");
  return { { normal_force / (2. * pi), -moment.y() / (pi * radius) },
           { 0., moment.x() / (pi * radius) },
           radius };
}

std::vector<double> RingStack::radii() const
{
  std::vector<double> values;
  for (const Ring &ring : stack)
    values.push_back(ring.radius);
  return values;
}

double RingStack::radius() const
{
  if (stack.size() == 1)
    return stack.front().radius;
  double sum = 0., weights = 0.;
  for (const Ring &ring : stack)
  {
    sum += std::abs(ring.a[0]) * ring.radius;
    weights += std::abs(ring.a[0]);
  }
  // If the first harmonics of the rings cancel, the moment is a rounding error and defines no radius.
  constexpr double no_moment = 1e-9;
  const double moment_norm = moment().norm();
  return moment_norm > no_moment * 2. * pi * sum ? moment_norm / (pi * std::hypot(a(1), b(1)))
                                                 : sum / weights;
}

double RingStack::normal_force() const
{
  return 2. * pi * cosine[0];
}

Eigen::Vector2d RingStack::moment() const
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  if (n_harmonics() >= 1)
    for (const Ring &ring : stack)
      sum += pi * ring.radius * Eigen::Vector2d(ring.b[1], -ring.a[1]);
  return sum;
}

double RingStack::moment_ratio(double contact_radius) const
{
  require_positive(contact_radius, "the contact radius", "m");
  return 2. * moment().norm() / (normal_force() * contact_radius);
}

double RingStack::operator()(double theta) const
{
  double sum = cosine[0];
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += cosine[n] * std::cos(n * theta) + sine[n] * std::sin(n * theta);
  return sum;
}

double RingStack::derivative(double theta) const
{
  double sum = 0.;
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += n * (sine[n] * std::cos(n * theta) - cosine[n] * std::sin(n * theta));
  return sum;
}

std::vector<double> RingStack::evenly_spaced_values() const
{
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

std::map<double, double> RingStack::local_minima() const
{
  const std::vector<double> samples = evenly_spaced_values();
  const std::size_t n_samples = samples.size();
  const double spacing = 2. * pi / static_cast<double>(n_samples);
  std::map<double, double> minima;
  for (std::size_t i = 0; i < n_samples; ++i)
    if (samples[i] <= samples[(i + 1) % n_samples] && samples[i] <= samples[(i + n_samples - 1) % n_samples])
    {
      const double middle = static_cast<double>(i) * spacing;
      const double least =
        sign_change([this](double theta) { return derivative(theta); }, middle - spacing, middle + spacing);
      minima.emplace(least, (*this)(least));
      minima.emplace(middle, samples[i]);
    }
  return minima;
}

double RingStack::minimum() const
{
  if (n_harmonics() <= 1)
    return cosine[0] - std::hypot(a(1), b(1));
  double least = std::numeric_limits<double>::infinity();
  for (const auto &[theta, value] : local_minima())
    least = std::min(least, value);
  return least;
}

double RingStack::integral(double from, double to) const
{
  double sum = cosine[0] * (to - from);
  for (unsigned int n = 1; n < cosine.size(); ++n)
    sum += (cosine[n] * (std::sin(n * to) - std::sin(n * from)) -
            sine[n] * (std::cos(n * to) - std::cos(n * from))) /
           n;
  return sum;
}

double RingStack::pulling_force() const
{
  // The load may be negative only between two samples, so the local minima are added.
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

RingStack RingStack::truncated(unsigned int n_max) const
{
  std::vector<Ring> kept(stack);
  for (Ring &ring : kept)
  {
    const std::size_t n_kept = std::min(n_max, n_harmonics()) + 1;
    ring.a.resize(n_kept);
    ring.b.resize(n_kept);
  }
  return RingStack(std::move(kept));
}

RingStack RingStack::rotated(double angle) const
{
  require_finite(angle, "the angle of rotation");
  std::vector<Ring> turned(stack);
  for (std::size_t j = 0; j < stack.size(); ++j)
    for (unsigned int n = 1; n <= n_harmonics(); ++n)
    {
      const double c = std::cos(n * angle), s = std::sin(n * angle);
      turned[j].a[n] = stack[j].a[n] * c - stack[j].b[n] * s;
      turned[j].b[n] = stack[j].a[n] * s + stack[j].b[n] * c;
    }
  return RingStack(std::move(turned));
}

double RingStack::difference(const RingStack &other) const
{
  double largest = std::abs(radius() / other.radius() - 1.);
  for (unsigned int n = 0; n <= std::max(n_harmonics(), other.n_harmonics()); ++n)
    largest = std::max(
      { largest, std::abs(a(n) - other.a(n)) / other.a(0), std::abs(b(n) - other.b(n)) / other.a(0) });
  return largest;
}
} // namespace stemware::ring
