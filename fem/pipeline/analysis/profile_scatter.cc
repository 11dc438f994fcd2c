#include "fem/pipeline/analysis/profile_scatter.h"

#include "fem/pipeline/analysis/study_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Adds the study with a rim that is a step smaller, and one that is a step larger in one of its two lengths,
/// which @p change does to it.
void add_both_sides(const Study &study, const std::function<void(fem::GlassProfile &, double steps)> &change,
                    std::vector<Variant> &variants)
{
  for (const int steps : { -1, 1 })
    change(variants.emplace_back(Variant{ "", "", study }).study.glass.profile, steps);
}

/// Half of what the terminal spin changes by from row @p i, one step less, to the next, one step more
/// [rad/s]; nothing where one of the two has no spin, and @p reason says why.
std::optional<double> change_of_spin(const std::vector<LoadedRow> &rows, std::size_t i, std::string &reason)
{
  for (const std::size_t side : { i, i + 1 })
    if (!rows[side].row.terminal)
    {
      reason = rows[side].row.reason;
      return std::nullopt;
    }
  return (rows[i + 1].row.terminal->omega - rows[i].row.terminal->omega) / 2;
}

} // namespace

std::optional<ProfileScatter> profile_scatter(const Study &given, const SpinRow &all,
                                              const Executor &executor, Progress &progress)
{
  const auto &circle = given.glass.rim_circle;
  if (!circle || !circle->has_scatter() || !all.terminal || given.load.source == LoadSource::file ||
      !given.contact.mesh_file.empty() || std::abs(all.terminal->omega) < 1e-9 * spin_unit(given))
    return std::nullopt;
  // Two digits of a derivative need neither a mesh for a goal, nor three dimensions, nor a mean over phases.
  Study study = given;
  if (!abilities(study.contact.body).is_of_revolution)
    study.contact.degree = ContactSection().degree;
  study.contact.body = BodyKind::revolution;
  study.contact.halved.clear();
  study.model.waviness = false;

  // Smaller steps would show the rounding of contacts; larger ones leave the land.
  const double radius_step = std::min(std::max(circle->contact_radius_error(), 1e-3 * circle->contact_radius),
                                      study.glass.profile.land_width / 8);
  const double curvature = 1 / circle->crown_radius;
  const double curvature_step = curvature * std::clamp(circle->crown_radius_error() * curvature, 0.01, 0.5);

  SpinQuestion question;
  question.near = given.has_waviness() ? std::nullopt : known_zero(all);
  question.with_minima = false;
  const bool has_radius = circle->contact_radius_error() > 0, has_crown = circle->crown_radius_error() > 0;
  std::vector<Variant> variants;
  if (has_radius)
    add_both_sides(
      study, [=](fem::GlassProfile &profile, double steps) { profile.contact_radius += steps * radius_step; },
      variants);
  if (has_crown)
    add_both_sides(
      study,
      [=](fem::GlassProfile &profile, double steps)
      { profile.crown_radius = 1 / (1 / profile.crown_radius + steps * curvature_step); },
      variants);
  const std::vector<LoadedRow> rows =
    solve_rows(variants, nullptr, question, executor, progress, "scatter of the profile");

  ProfileScatter scatter;
  if (has_radius)
  {
    const auto change = change_of_spin(rows, 0, scatter.reason);
    if (!change)
      return scatter;
    scatter.by_contact_radius = *change / radius_step;
  }
  if (has_crown)
  {
    const auto change = change_of_spin(rows, has_radius ? 2 : 0, scatter.reason);
    if (!change)
      return scatter;
    // d(curvature) / d(crown radius) = -curvature^2
    scatter.by_crown_radius = -*change / curvature_step * curvature * curvature;
  }
  const double gradient[] = { scatter.by_contact_radius.value_or(0), scatter.by_crown_radius.value_or(0) };
  double variance = 0;
  for (const std::size_t i : { 0, 1 })
    for (const std::size_t j : { 0, 1 })
      variance += gradient[i] * circle->covariance[i][j] * gradient[j];
  scatter.spin = std::sqrt(std::max(0., variance));
  return scatter;
}

} // namespace stemware::pipeline
