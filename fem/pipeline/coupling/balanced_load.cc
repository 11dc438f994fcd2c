#include "fem/pipeline/coupling/balanced_load.h"

#include "fem/pipeline/coupling/load_curve.h"
#include "ring_model/self_consistent_ring.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// A load without its harmonics above some number.
class TruncatedLoad : public ChangedLoad
{
public:
  TruncatedLoad(SharedLoad whole, unsigned int n_harmonics)
      : ChangedLoad(std::move(whole))
      , n_kept(n_harmonics)
  {
  }

  LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks) const override
  {
    return whole->at(omega, marks).truncated(n_kept);
  }
  unsigned int n_harmonics() const override { return n_kept; }

private:
  const unsigned int n_kept;
};

/// A load interpolated between samples on an interval of spins.
class InterpolatedLoad : public ChangedLoad
{
public:
  InterpolatedLoad(SharedLoad whole, const LoadCurve &curve, double lower, double upper)
      : ChangedLoad(std::move(whole))
      , inside(curve)
      , lower(lower)
      , upper(upper)
  {
  }

  LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks) const override
  {
    return lower <= omega && omega <= upper ? inside(omega) : whole->at(omega, marks);
  }
  bool is_costly() const override { return false; }
  std::optional<CouplingStatistics> statistics() const override
  {
    std::optional<CouplingStatistics> statistics = whole->statistics();
    if (statistics)
      statistics->interpolation_error = inside.error();
    return statistics;
  }
  /// The load between @p begin and @p end where one polynomial gives it; else nothing.
  LoadFunction polynomial_on(double begin, double end) const
  {
    return inside.n_pieces() == 1 && lower <= begin && end <= upper ? inside : LoadFunction();
  }

private:
  const LoadCurve inside;
  const double lower, upper;
};

/// The load of a model of the ring in balance at every spin. Loads are kept.
class ModelInBalance : public GivenLoad
{
public:
  ModelInBalance(const ring::SelfConsistentRing &glass, LoadReport at_rest)
      : GivenLoad(std::move(at_rest))
      , glass(glass)
  {
  }

  LeaningLoad at(double omega, const std::optional<ring::Orientation> &) const override
  {
    if (omega == 0)
      return report().rings;
    auto found = loads.find(omega);
    if (found == loads.end())
      found = loads.emplace(omega, glass.at(omega).load).first;
    return found->second;
  }
  std::optional<CouplingStatistics> statistics() const override { return CouplingStatistics{ loads.size() }; }

private:
  const ring::SelfConsistentRing glass;
  mutable std::map<double, ring::RingStack> loads;
};

} // namespace

SharedLoad BalancedLoad::truncated(unsigned int n_harmonics) const
{
  if (n_harmonics >= this->n_harmonics())
    return shared_from_this();
  return std::make_shared<TruncatedLoad>(shared_from_this(), n_harmonics);
}

SharedLoad BalancedLoad::interpolated(double lower, double upper, double enough,
                                      const BalancedLoad *like) const
{
  if (!is_costly() || !(lower < upper))
    return shared_from_this();
  CurveSource source = { [this](double omega) { return at(omega); },
                         [this](double omega) { return clearance(omega); }, known_spins() };
  const auto *other = dynamic_cast<const InterpolatedLoad *>(like);
  if (other && other->report().rings.radii() == report().rings.radii())
    source.reference = other->polynomial_on(lower, upper);
  CurveTolerance tolerance;
  tolerance.enough = enough;
  const LoadCurve curve(source, lower, upper, tolerance);
  if (curve.error() > tolerance.coarsest)
    return shared_from_this();
  return std::make_shared<InterpolatedLoad>(shared_from_this(), curve, lower, upper);
}

SharedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const ring::Motion &motion,
                   ring::Closure closure, LoadReport at_rest, unsigned int n_harmonics)
{
  if (n_harmonics < at_rest.rings.n_harmonics())
    at_rest.rings = at_rest.rings.truncated(n_harmonics);
  return std::make_shared<ModelInBalance>(ring::SelfConsistentRing(closure, motion, model, n_harmonics),
                                          std::move(at_rest));
}

LoadReport report_of(const ring::RingStack &load)
{
  constexpr unsigned int n_azimuths = 3600;
  unsigned int n_loaded = 0;
  for (unsigned int i = 0; i < n_azimuths; ++i)
    n_loaded += load(boost::math::double_constants::two_pi * (i + 0.5) / n_azimuths) > 0 ? 1 : 0;
  LoadReport report = { load };
  report.normal_force = load.normal_force();
  report.moment = load.moment();
  report.moment_ratio = load.moment_ratio(load.radius());
  report.mean_radius = load.radius();
  report.contact_fraction = static_cast<double>(n_loaded) / n_azimuths;
  report.azimuth_fraction = report.contact_fraction;
  report.minimum = load.minimum();
  return report;
}

} // namespace stemware::pipeline
