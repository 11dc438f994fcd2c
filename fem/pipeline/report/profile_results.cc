#include "fem/pipeline/report/profile_results.h"

#include "fem/pipeline/document/json.h"
#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/study/profile_file.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The circle whose scatter leaves something open; null where there is none.
const fem::RimCircle *scattered_circle(const Study &study)
{
  const auto &circle = study.glass.rim_circle;
  return circle && circle->has_scatter() ? circle.get() : nullptr;
}

/// Whether the crown is fitted, and rises over the contact by less than the points scatter.
bool crown_is_below_scatter(const Study &study, const fem::RimCircle &circle, const LoadReport &load)
{
  const double sag = sag_over_contact(study, load);
  return circle.crown_radius_error() > 0 && sag > 0 && sag < circle.scatter;
}

} // namespace

std::optional<double> spin_error(const std::optional<ProfileScatter> &scatter)
{
  return scatter && scatter->spin && *scatter->spin > 0 ? scatter->spin : std::nullopt;
}

double sag_over_contact(const Study &study, const LoadReport &load)
{
  const double crown = study.glass.profile.crown_radius;
  return crown > 0 ? load.half_width() * load.half_width() / (2 * crown) : 0;
}

Json profile_facts(const Study &study, const LoadReport &load, const std::optional<ProfileScatter> &scatter,
                   const std::optional<double> &band)
{
  const fem::RimCircle *circle = scattered_circle(study);
  if (!circle)
    return nullptr;
  const fem::GlassProfile &profile = study.glass.profile;
  const std::optional<double> error = spin_error(scatter);
  const bool is_below_scatter = crown_is_below_scatter(study, *circle, load);
  const auto length = [](double value, double error)
  { return error > 0 ? format::with_error(1e3 * value, 1e3 * error) : format::number(1e3 * value, ".6g"); };
  return { { "rim", fitted_rim(study) },
           { "spin_error", error ? format::to_spread(*error, *error) : "" },
           { "band", band },
           { "trouble", scatter && !scatter->spin ? scatter->reason : "" },
           { "crown_below_scatter", is_below_scatter },
           { "crown_open", !is_below_scatter && crown_is_open(*circle) },
           { "contact_width", 2 * load.half_width() },
           { "sag", sag_over_contact(study, load) },
           { "scatter", circle->scatter },
           { "land_width", profile.land_width },
           { "contact_radius", length(profile.contact_radius, circle->contact_radius_error()) },
           { "crown_radius", length(profile.crown_radius, circle->crown_radius_error()) },
           { "n_points", circle->points.size() },
           { "freedom", circle->freedom } };
}

Json with_scatter_row(Json chain, const std::optional<ProfileScatter> &scatter)
{
  if (const std::optional<double> error = spin_error(scatter))
  {
    Json row = chain[0];
    for (auto &value : row)
      value = "";
    row["title"] = row["console_title"] = "scatter of the profile";
    row["band"] = *error;
    row["remark"] = "one standard error";
    chain.push_back(row);
  }
  return chain;
}

Json profile_summary(const Study &study)
{
  const GlassSection &glass = study.glass;
  const fem::RimCircle *circle = glass.rim_circle.get(), *scattered = scattered_circle(study);
  const auto of = [](const fem::RimCircle *circle, auto value)
  { return circle ? Json(std::invoke(value, *circle)) : Json(nullptr); };
  return { { "points", glass.n_profile_points },
           { "contact_radius", glass.profile.contact_radius },
           { "crown_radius", glass.profile.crown_radius },
           { "contact_radius_error", of(scattered, &fem::RimCircle::contact_radius_error) },
           { "crown_radius_error", of(scattered, &fem::RimCircle::crown_radius_error) },
           { "covariance", of(scattered, &fem::RimCircle::covariance) },
           { "scatter", of(circle && circle->freedom > 0 ? circle : nullptr, &fem::RimCircle::scatter) },
           { "degrees_of_freedom", of(circle, &fem::RimCircle::freedom) },
           { "rim_points", circle ? circle->points.size() : 0 },
           { "repeated_points", circle ? circle->n_repeated : 0 },
           { "crown_determined", !circle || !crown_is_open(*circle) } };
}

Json profile_summary(const Study &study, const LoadReport &load, const std::optional<ProfileScatter> &scatter)
{
  Json summary = profile_summary(study);
  summary["sag_over_contact"] = sag_over_contact(study, load);
  if (const fem::RimCircle *circle = scattered_circle(study))
    summary["crown_determined"] = !crown_is_open(*circle) && !crown_is_below_scatter(study, *circle, load);
  const ProfileScatter known = scatter.value_or(ProfileScatter());
  summary["omega_terminal_error"] = known.spin;
  summary["omega_by_contact_radius"] = known.by_contact_radius;
  summary["omega_by_crown_radius"] = known.by_crown_radius;
  if (!known.reason.empty())
    summary["reason"] = known.reason;
  return summary;
}

} // namespace stemware::pipeline
