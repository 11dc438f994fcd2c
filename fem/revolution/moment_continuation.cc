#include "fem/revolution/moment_continuation.h"

#include "fem/geometry/require.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::fem
{

namespace
{

/// Last two contact solutions of the continuation.
struct Path
{
  ContactSolution last;
  ContactSolution before;
  double share = 0; ///< fraction of the full moment in `last`
  double step = 0;  ///< increase of `share` from `before` to `last`; 0 at the beginning

  /// Returns the linear extrapolation to the share @p next.
  ContactStart start(double next) const
  {
    const double ahead = step > 0 ? (next - share) / step : 0;
    return { last.motion + ahead * (last.motion - before.motion),
             last.normal_displacement + ahead * (last.normal_displacement - before.normal_displacement) };
  }

  void append(double next, ContactSolution solution)
  {
    before = std::exchange(last, std::move(solution));
    step = next - share;
    share = next;
  }

  /// Returns true if the last step tilted the foot more than three times as much per moment as the average of
  /// all steps.
  bool is_steep() const
  {
    constexpr double much_steeper = 3;
    return step > 0 && (last.motion - before.motion).tail<2>().norm() / step >
                         much_steeper * last.motion.tail<2>().norm() / share;
  }
};

} // namespace

ContactSolution continue_in_moment(BodyOfRevolution &body, TableLaw &law, const LinearConditions &conditions,
                                   double radius, const ContactControl &usual, const ContactSolution &even)
{
  constexpr double shortest_step = 1. / 512;
  const ContactSurface &surface = body.contact_surface();
  ContactControl control = usual;
  control.full_steps = true;
  control.max_steps = 20;

  Path path = { even, even };
  double step = 1. / 8;
  while (path.share < 1)
    try
    {
      const double next = std::min(1., path.share + step);
      const ContactStart start = path.start(next);
      body.set_forces(path.last.forces);
      path.append(next, solve_contact(body, law, conditions.with_scaled_moment(surface, next), radius,
                                      control, &start));
      step *= 1.5;
    }
    catch (const ContactFailure &)
    {
      step /= 2;
      if (step >= shortest_step)
        continue;
      if (conditions.are_resultants() || !path.is_steep())
        throw;
      throw ContactFailure(
        ContactOutcome::tipping,
        sentence("the required moment grows faster with the tilt than the moment of the contact; the balance "
                 "ends at ",
                 std::round(1000 * path.share) / 10,
                 " % of the moment. Lower the centre of mass or the hand, or reduce the speed."));
    }
  return path.last;
}

} // namespace stemware::fem
