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

/// A length of the rim that has a scatter.
struct ScatteredLength
{
  std::optional<double> ProfileScatter::*slope; ///< of the terminal spin
  double step;
  std::function<void(fem::GlassProfile &, double change)> add; ///< a change of one step in either direction
};

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
  std::vector<ScatteredLength> lengths;
  if (circle->contact_radius_error() > 0)
    lengths.push_back({ &ProfileScatter::by_contact_radius, radius_step,
                        [](fem::GlassProfile &profile, double change)
                        { profile.contact_radius += change; } });
  if (circle->crown_radius_error() > 0)
    lengths.push_back({ &ProfileScatter::by_crown_radius, curvature_step,
                        [](fem::GlassProfile &profile, double change)
                        { profile.crown_radius = 1 / (1 / profile.crown_radius + change); } });
  std::vector<Variant> variants;
  for (const ScatteredLength &length : lengths)
    for (const int steps : { -1, 1 })
      length.add(variants.emplace_back(Variant{ "", "", study }).study.glass.profile, steps * length.step);
  const std::vector<LoadedRow> rows =
    solve_rows(variants, nullptr, question, executor, progress, "scatter of the profile");

  ProfileScatter scatter;
  for (std::size_t i = 0; i < rows.size(); i += 2)
  {
    for (const std::size_t side : { i, i + 1 })
      if (!rows[side].row.terminal)
      {
        scatter.reason = rows[side].row.reason;
        return scatter;
      }
    const double change = (rows[i + 1].row.terminal->omega - rows[i].row.terminal->omega) / 2;
    scatter.*lengths[i / 2].slope = change / lengths[i / 2].step;
  }
  if (scatter.by_crown_radius) // d(curvature) / d(crown radius) = -curvature^2
    scatter.by_crown_radius = -*scatter.by_crown_radius * curvature * curvature;
  const double gradient[] = { scatter.by_contact_radius.value_or(0), scatter.by_crown_radius.value_or(0) };
  double variance = 0;
  for (const std::size_t i : { 0, 1 })
    for (const std::size_t j : { 0, 1 })
      variance += gradient[i] * circle->covariance[i][j] * gradient[j];
  scatter.spin = std::sqrt(std::max(0., variance));
  return scatter;
}

} // namespace stemware::pipeline
