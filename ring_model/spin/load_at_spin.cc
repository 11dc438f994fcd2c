#include "ring_model/spin/load_at_spin.h"

#include "ring_model/spin/spin_curve.h"

namespace stemware::ring
{
namespace
{
/// A load without its harmonics above some number.
class TruncatedLoad : public LoadDecorator
{
public:
  TruncatedLoad(SharedLoad whole, unsigned int n_harmonics)
      : LoadDecorator(std::move(whole))
      , n_kept(n_harmonics)
  {
  }

  LeaningLoad at(double omega, const std::optional<Orientation> &marks) const override
  {
    return whole->at(omega, marks).truncated(n_kept);
  }
  unsigned int n_harmonics() const override { return n_kept; }

private:
  const unsigned int n_kept;
};

/// A load interpolated between samples on an interval of spins.
class InterpolatedLoad : public LoadDecorator
{
public:
  InterpolatedLoad(SharedLoad whole, const SpinCurve &curve, double lower, double upper)
      : LoadDecorator(std::move(whole))
      , inside(curve)
      , lower(lower)
      , upper(upper)
  {
  }

  LeaningLoad at(double omega, const std::optional<Orientation> &marks) const override
  {
    return lower <= omega && omega <= upper ? inside(omega) : whole->at(omega, marks);
  }
  bool is_costly() const override { return false; }
  std::optional<double> interpolation_error() const override { return inside.error(); }
  /// Returns the load between @p begin and @p end if one polynomial gives it; else an empty function.
  LoadFunction polynomial_on(double begin, double end) const
  {
    return inside.n_pieces() == 1 && lower <= begin && end <= upper ? inside : LoadFunction();
  }

private:
  const SpinCurve inside;
  const double lower, upper;
};
} // namespace

SharedLoad truncated(const SharedLoad &load, unsigned int n_harmonics)
{
  if (n_harmonics >= load->n_harmonics())
    return load;
  return std::make_shared<TruncatedLoad>(load, n_harmonics);
}

SharedLoad interpolated(const SharedLoad &load, double lower, double upper, double enough,
                        const LoadAtSpin *like)
{
  if (!load->is_costly() || !(lower < upper))
    return load;
  CurveSource source = { [&](double omega) { return load->at(omega); },
                         [&](double omega) { return load->lift_off_margin(omega); }, load->known_spins() };
  const auto *other = dynamic_cast<const InterpolatedLoad *>(like);
  if (other && other->at(0., {}).radii() == load->at(0.).radii())
    source.reference = other->polynomial_on(lower, upper);
  CurveTolerance tolerance;
  tolerance.enough = enough;
  const SpinCurve curve(source, lower, upper, tolerance);
  if (curve.error() > tolerance.coarsest)
    return load;
  return std::make_shared<InterpolatedLoad>(load, curve, lower, upper);
}
} // namespace stemware::ring
