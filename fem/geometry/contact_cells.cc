#include "fem/geometry/contact_cells.h"

#include "fem/geometry/require.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

/// Relative tolerance for rounding errors of lengths.
constexpr double rounding = 1e-9;

/// Maximum number of contact cells, limited by the memory for their compliances.
constexpr std::size_t max_cells = 2000;

/// Returns cells that are symmetric about the contact radius and smallest at this radius.
ContactCells graded_cells(const GlassProfile &profile, const MeridianResolution &resolution)
{
  const unsigned int half = resolution.land_cells / 2;
  std::vector<double> offsets = { 0 };
  for (unsigned int i = 0; i < half; ++i)
    offsets.push_back(offsets.back() + std::pow(resolution.land_grading, i));
  ContactCells cells;
  for (unsigned int i = 0; i <= 2 * half; ++i)
  {
    const double offset = i < half ? -offsets[half - i] : offsets[i - half];
    cells.coarse.push_back(profile.contact_radius + offset / offsets.back() * profile.land_width / 2);
  }
  cells.borders = cells.coarse;
  cells.coarse_size = profile.land_width / 2 / offsets.back();
  return cells;
}

/// Adds coarse cells of nearly equal size with a border at @p focus_radius.
void add_coarse_cells(const GlassProfile &profile, const MeridianResolution &resolution, double focus_radius,
                      ContactCells &cells)
{
  // At least two cells lie on each side of the contact radius.
  const double largest = std::min(profile.land_width / 4, 2 * lowest_cell_height(profile));
  const double n_halvings =
    std::max(0., std::floor(std::log2(largest / resolution.focus_size * (1 + rounding))));
  cells.coarse_size = std::min(largest, std::ldexp(resolution.focus_size, static_cast<int>(n_halvings)));

  const double inner = profile.land_inner_radius();
  const double outer = profile.land_outer_radius();
  const double size = cells.coarse_size;
  // The cells next to the borders of the land absorb the remainder, so their size is 0.5 to 1.5 times `size`.
  double middle = focus_radius;
  const auto n_from_middle = [&](double border)
  { return static_cast<int>(std::floor(std::abs(border - middle) / size + 0.5)); };
  if (n_from_middle(inner) == 0)
    middle = inner;
  else if (n_from_middle(outer) == 0)
    middle = outer;
  cells.coarse = { inner };
  for (int i = 1 - n_from_middle(inner); i < n_from_middle(outer); ++i)
    cells.coarse.push_back(middle + i * size);
  cells.coarse.push_back(outer);
}

ContactCells focused_cells(const GlassProfile &profile, const MeridianResolution &resolution)
{
  const double focus = resolution.focus_radius > 0 ? resolution.focus_radius : profile.contact_radius;
  require(focus >= profile.land_inner_radius() * (1 - rounding) &&
            focus <= profile.land_outer_radius() * (1 + rounding),
          "The focus of the contact cells, r = ", focus, " m, lies outside the land, ",
          profile.land_inner_radius(), " m to ", profile.land_outer_radius(), " m.");
  ContactCells result;
  result.has_focus = true;
  result.focus_begin = focus - resolution.focus_width;
  result.focus_end = focus + resolution.focus_width;
  add_coarse_cells(profile, resolution, focus, result);

  std::vector<double> &borders = result.borders;
  std::vector<unsigned int> &n_halvings = result.n_halvings;
  borders = result.coarse;
  n_halvings.assign(borders.size() - 1, 0);
  const double largest = profile.land_width / resolution.land_cells;
  const auto is_too_large = [&](std::size_t i)
  {
    const double distance =
      std::max({ borders[i] - result.focus_end, result.focus_begin - borders[i + 1], 0. });
    const auto is_finer = [&](std::size_t j) { return n_halvings[j] > n_halvings[i] + 1; };
    return borders[i + 1] - borders[i] > std::min(largest, resolution.size_at(distance)) * (1 + rounding) ||
           (i > 0 && is_finer(i - 1)) || (i + 1 < n_halvings.size() && is_finer(i + 1));
  };
  for (std::size_t i = 0; i < n_halvings.size();)
  {
    if (!is_too_large(i))
    {
      ++i;
      continue;
    }
    const auto place = static_cast<std::ptrdiff_t>(i);
    borders.insert(borders.begin() + place + 1, (borders[i] + borders[i + 1]) / 2);
    n_halvings.insert(n_halvings.begin() + place, ++n_halvings[i]);
    require(n_halvings.size() <= max_cells, "Contact cells of ", resolution.focus_size, " m within ",
            resolution.focus_width, " m of their focus are more than ", max_cells,
            "; ask for larger ones or a narrower band.");
    if (i > 0)
      --i; // the cell inside may now be too large
  }
  return result;
}

} // namespace

void TableDisc::validate(const GlassProfile &profile) const
{
  require(std::isfinite(thickness) && thickness > 0, "Disc thickness = ", thickness,
          " m is not allowed; give a finite number greater than 0.");
  require(std::isfinite(radius) && radius > profile.land_outer_radius(), "Disc radius = ", radius,
          " m is not allowed; it must be larger than the outer radius of the land, ",
          profile.land_outer_radius(), " m.");
}

void MeridianResolution::validate() const
{
  require(land_cells >= 2 && land_cells % 2 == 0, "Radial cells = ", land_cells,
          " is not allowed for a body of revolution; give an even number of at least 2.");
  require(land_grading >= 1 && land_grading <= 10, "The grading of the land, ", land_grading,
          ", must lie between 1 (equal cells) and 10.");
  require(refinements <= 6, refinements, " halvings of every meridional cell are too many; give at most 6.");
  require(focus_size == 0 || focus_size >= 1e-10, "Contact cells of ", focus_size,
          " m are not allowed; give at least 1e-10 m, or 0 for none of a given size.");
  require(std::isfinite(focus_radius) && focus_radius >= 0,
          "The focus of the contact cells, r = ", focus_radius, " m, must be a radius.");
  require(focus_width >= 0, "Half the width of the focus, ", focus_width, " m, must be a length.");
  require(focus_growth > 1 && focus_growth <= 4, "The growth of the contact cells, ", focus_growth,
          ", must be larger than 1 and at most 4.");
}

ContactCells contact_cells(const GlassProfile &profile, const MeridianResolution &resolution)
{
  profile.validate();
  resolution.validate();
  return resolution.has_focus() ? focused_cells(profile, resolution) : graded_cells(profile, resolution);
}

double lowest_cell_height(const GlassProfile &profile)
{
  if (profile.shape == GlassShape::step)
    return profile.land_height;
  return lowest_level * (profile.topside(profile.contact_radius) - profile.underside(profile.contact_radius));
}

} // namespace stemware::fem
