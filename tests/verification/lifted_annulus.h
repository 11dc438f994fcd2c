#pragma once

// A rigid flat annulus or disc on a Winkler mat with lift-off, from closed forms of circular segments.
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>

namespace stemware::verification
{

/// Area of the part x > c of a disc of radius a, and first and second moments of the area in x.
struct Segment
{
  Segment(double a, double c)
  {
    c = std::min(std::max(c, -a), a);
    const double root = std::sqrt(a * a - c * c), angle = std::acos(c / a);
    area = a * a * angle - c * root;
    first = 2. / 3 * root * root * root;
    second = a * a * a * a / 4 * angle - c * (2 * c * c - a * a) * root / 4;
  }
  double area, first, second;
};

/// Contact edge c of an annulus under a force at @p eccentricity, with the pressure p ~ x - c for x > c, and
/// the share of the area with x > c (1 in full contact).
struct LiftedAnnulus
{
  LiftedAnnulus(double inner, double outer, double eccentricity)
  {
    const auto beyond = [&](double c, auto moment)
    { return moment(Segment(outer, c)) - (inner > 0 ? moment(Segment(inner, c)) : 0); };
    const auto centre = [&](double c)
    {
      const double area = beyond(c, [](const Segment &s) { return s.area; }),
                   first = beyond(c, [](const Segment &s) { return s.first; }),
                   second = beyond(c, [](const Segment &s) { return s.second; });
      per_slope = first - c * area;
      return (second - c * first) / per_slope;
    };
    double low = -outer, high = outer * (1 - 1e-9);
    for (unsigned int i = 0; i < 200; ++i)
      (centre((low + high) / 2) < eccentricity ? low : high) = (low + high) / 2;
    zero = low;
    centre(zero);
    share =
      beyond(zero, [](const Segment &s) { return s.area; }) / (ring::pi * (outer * outer - inner * inner));
  }
  double zero, share;
  double per_slope; ///< force per slope of the pressure [m^3]
};

} // namespace stemware::verification
