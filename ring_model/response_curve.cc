#include "ring_model/response_curve.h"

#include "ring_model/constants.h"
#include "ring_model/require.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Moment ratio with the nominal radius.
double ratio_of(const RingStack &load, double nominal_radius)
{
  return load.moment().norm() / (0.5 * load.normal_force() * nominal_radius);
}

/// The load turned so that its first harmonic is a pure cosine.
RingStack aligned(const RingStack &load)
{
  return load.rotated(-std::atan2(load.b(1), load.a(1)));
}

/// Refuses harmonics that are not symmetric about theta = 0; without moment, any harmonics.
void check_harmonics(const RingStack &load, std::size_t index, bool without_moment, double tolerance)
{
  for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
    require(std::abs(load.b(n)) <= tolerance * load.a(0) &&
              (!without_moment || std::abs(load.a(n)) <= tolerance * load.a(0)),
            "harmonic ", n, " of sample ", index, " is (", load.a(n), ", ", load.b(n),
            ") N/rad about the direction of its moment, not symmetric to ", tolerance,
            " a_0: this load depends on more than the moment ratio (a foot that is no body of revolution, or "
            "friction "
            "coupling); solve the contact at every state instead");
}

/// What all samples of a curve have in common.
struct Rules
{
  double nominal_radius;
  double normal_force;
  double tolerance;         ///< on the symmetry of a sample
  unsigned int n_harmonics; ///< of the curve
};

/// Moment ratios and shapes of one piece of a curve.
struct Nodes
{
  std::vector<double> ratios;
  std::vector<std::vector<double>> shapes; ///< ring radius and a_n / a_0 for n = 2, 3, ...
};

/// Adds sample number @p index of the curve; the very first has no moment.
void add_node(const RingStack &sample, std::size_t index, const Rules &rules, Nodes &nodes)
{
  const double ratio = ratio_of(sample, rules.nominal_radius);
  require(index > 0 || ratio < rules.tolerance, "the response curve starts at the moment ratio ", ratio,
          ", but must start with a load without moment");
  if (!nodes.ratios.empty())
    require(ratio > nodes.ratios.back(), "sample ", index, " has the moment ratio ", ratio, " after ",
            nodes.ratios.back(), ", but the ratios must increase");
  require(std::abs(sample.normal_force() - rules.normal_force) <= 1e-9 * rules.normal_force, "sample ", index,
          " has the normal force ", sample.normal_force(), " N, but the first has ", rules.normal_force,
          " N: a curve over the moment ratio needs one normal force");
  // Without moment a body of revolution has no harmonics, and no direction to turn the load to.
  const RingStack turned = index > 0 ? aligned(sample) : sample;
  check_harmonics(turned, index, index == 0, rules.tolerance);
  nodes.ratios.push_back(index > 0 ? ratio : 0.);
  nodes.shapes.emplace_back(1, sample.radius());
  for (unsigned int n = 2; n <= rules.n_harmonics; ++n)
    nodes.shapes.back().push_back(index > 0 ? turned.a(n) / turned.a(0) : 0.);
}

/// The nodes together with the mirror images (-m, radius, (-1)^n a_n / a_0) of all nodes but m = 0, which is
/// the first.
Nodes mirrored(const Nodes &nodes)
{
  Nodes both;
  for (std::size_t i = nodes.ratios.size() - 1; i > 0; --i)
  {
    both.ratios.push_back(-nodes.ratios[i]);
    both.shapes.push_back(nodes.shapes[i]);
    for (std::size_t k = 2; k < both.shapes.back().size(); k += 2) // n = k + 1 is odd
      both.shapes.back()[k] = -both.shapes.back()[k];
  }
  both.ratios.insert(both.ratios.end(), nodes.ratios.begin(), nodes.ratios.end());
  both.shapes.insert(both.shapes.end(), nodes.shapes.begin(), nodes.shapes.end());
  return both;
}
} // namespace

ResponseCurve::ResponseCurve(const std::vector<RingStack> &samples, double nominal_radius,
                             double lift_off_ratio, double tolerance)
    : ResponseCurve(std::vector<std::vector<RingStack>>{ samples }, nominal_radius, lift_off_ratio, tolerance)
{
}

ResponseCurve::ResponseCurve(const std::vector<std::vector<RingStack>> &pieces, double nominal_radius,
                             double lift_off_ratio, double tolerance, bool chebyshev_nodes)
    : nominal(nominal_radius)
    , onset(lift_off_ratio)
    , force(0.)
    , shape_size(0)
{
  require_positive(nominal_radius, "the nominal radius", "m");
  require(lift_off_ratio > 0., "the lift-off ratio is ", lift_off_ratio, ", but must be positive");
  for (const std::vector<RingStack> &samples : pieces)
    require(samples.size() >= 2, "the response curve has ", samples.size(),
            " samples, but needs at least two in every piece");
  require(!pieces.empty(), "the response curve has no samples, but needs at least two");
  force = pieces[0][0].normal_force();
  Rules rules = { nominal, force, tolerance, 1 };
  for (const std::vector<RingStack> &samples : pieces)
    for (const RingStack &sample : samples)
      rules.n_harmonics = std::max(rules.n_harmonics, sample.n_harmonics());
  shape_size = rules.n_harmonics;

  std::size_t index = 0; // of the sample, counted over all pieces
  for (const std::vector<RingStack> &samples : pieces)
  {
    Nodes nodes;
    for (const RingStack &sample : samples)
      add_node(sample, index++, rules, nodes);
    const double first = nodes.ratios.front(), last = nodes.ratios.back();
    require(curve.empty() || first == curve.rbegin()->first,
            "a piece of the response curve begins at the moment ratio ", first,
            ", but the piece before ends at another one");
    if (curve.empty() && !chebyshev_nodes)
      nodes = mirrored(nodes);
    const std::size_t highest = nodes.ratios.size() - 1;
    const std::size_t order = chebyshev_nodes ? highest : std::min<std::size_t>(5, highest);
    curve.emplace(last, Interpolant(std::move(nodes.ratios), std::move(nodes.shapes), order));
  }
}

double ResponseCurve::moment_ratio_limit() const
{
  return std::min(2., std::nextafter(curve.rbegin()->first, 2.));
}

RingStack ResponseCurve::rings(double normal_force, const Eigen::Vector2d &moment,
                               const Slip & /*slip*/) const
{
  require(std::abs(normal_force - force) <= 1e-9 * force, "the normal force is ", normal_force,
          " N, but the response curve was computed for ", force, " N");
  require(moment.allFinite(), "the moment is (", moment.x(), ", ", moment.y(), ") N m, but must be finite");
  const double ratio = moment.norm() / (0.5 * normal_force * nominal);
  const double last_ratio = curve.rbegin()->first;
  if (ratio >= 2.)
    throw Tipping(sentence("the moment ratio is ", ratio, ", but a ring that cannot pull tips at 2"));
  if (ratio > last_ratio * (1. + 1e-14))
    throw std::out_of_range(sentence("the moment ratio is ", ratio, ", but the response curve ends at ",
                                     last_ratio, ": add contact solutions up to there"));
  const auto piece = curve.lower_bound(ratio);
  Shape shape(shape_size);
  (piece == curve.end() ? curve.rbegin()->second : piece->second)(shape, ratio);

  const double a0 = normal_force / (2. * pi), ring = shape[0];
  std::vector<double> a{ a0, moment.norm() / (pi * ring) };
  for (std::size_t k = 1; k < shape_size; ++k)
    a.push_back(a0 * shape[k]);
  std::vector<double> b(a.size(), 0.);
  return RingStack(std::move(a), std::move(b), ring).rotated(std::atan2(moment.x(), -moment.y()));
}
} // namespace stemware::ring
