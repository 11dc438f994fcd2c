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

/// The study with a rim that is @p steps steps larger or smaller in one of its two lengths.
using ChangeRim = std::function<void(fem::GlassProfile &profile, double steps)>;

/// Half of what the terminal spin changes by from one step less to one step more [rad/s]; nothing where one
/// of the two has no spin, and @p reason says why.
std::optional<double> change_of_spin(const Study &study, const std::optional<ring::KnownZero> &near,
                                     const ChangeRim &change, fem::ComplianceCache &cache,
                                     std::string &reason)
{
  double spins[2] = {};
  for (const int side : { 0, 1 })
  {
    Study changed = study;
    change(changed.glass.profile, side == 0 ? -1 : 1);
    SpinQuestion question = spin_question(changed);
    question.near = near;
    question.with_minima = false;
    const SpinRow row = attempt_row(changed, cache, question, all_harmonics).row;
    if (!row.terminal)
    {
      reason = row.reason;
      return std::nullopt;
    }
    spins[side] = row.terminal->omega;
  }
  return (spins[1] - spins[0]) / 2;
}

} // namespace

std::optional<ProfileScatter> profile_scatter(const Study &given, const SpinRow &all,
                                              fem::ComplianceCache &cache, Progress &progress)
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

  const std::optional<ring::KnownZero> near = given.has_waviness() ? std::nullopt : known_zero(all);
  ProfileScatter scatter;
  if (circle->contact_radius_error() > 0)
  {
    const auto change = change_of_spin(
      study, near,
      [=](fem::GlassProfile &profile, double steps) { profile.contact_radius += steps * radius_step; }, cache,
      scatter.reason);
    if (!change)
      return scatter;
    scatter.by_contact_radius = *change / radius_step;
  }
  progress.pieces_done("scatter of the profile", 1, 2);
  if (circle->crown_radius_error() > 0)
  {
    const auto change = change_of_spin(
      study, near,
      [=](fem::GlassProfile &profile, double steps)
      { profile.crown_radius = 1 / (1 / profile.crown_radius + steps * curvature_step); },
      cache, scatter.reason);
    if (!change)
      return scatter;
    // d(curvature) / d(crown radius) = -curvature^2
    scatter.by_crown_radius = -*change / curvature_step * curvature * curvature;
  }
  progress.pieces_done("scatter of the profile", 2, 2);
  const double gradient[] = { scatter.by_contact_radius.value_or(0), scatter.by_crown_radius.value_or(0) };
  double variance = 0;
  for (const std::size_t i : { 0, 1 })
    for (const std::size_t j : { 0, 1 })
      variance += gradient[i] * circle->covariance[i][j] * gradient[j];
  scatter.spin = std::sqrt(std::max(0., variance));
  return scatter;
}

} // namespace stemware::pipeline
