#include "fem/pipeline/report/profile_results.h"

#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/number_format.h"
#include "fem/pipeline/report/render/table_renderers.h"
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

std::string with_error(double value, double error)
{
  return format::to_spread(value, error) + " ± " + format::to_spread(error, error);
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
  const std::optional<double> error = spin_error(scatter);
  const bool is_below_scatter = crown_is_below_scatter(study, *circle, load);
  return { { "rim", fitted_rim(study) },
           { "spin_error", error ? format::to_spread(*error, *error) : "" },
           { "band", band ? format::band(*band) : "" },
           { "trouble", scatter && !scatter->spin ? scatter->reason : "" },
           { "crown_below_scatter", is_below_scatter },
           { "crown_open", !is_below_scatter && crown_is_open(*circle) },
           { "contact_width", 2 * load.half_width() },
           { "sag", sag_over_contact(study, load) },
           { "scatter", circle->scatter },
           { "land_width", study.glass.profile.land_width } };
}

void add_scatter_row(const std::optional<ProfileScatter> &scatter, const std::string &title, Table &table)
{
  const std::optional<double> error = spin_error(scatter);
  if (!error)
    return;
  for (Column &column : table.columns)
  {
    const std::string &key = column.quantity.key;
    if (key == quantity::spin_band.key)
      column.cells.push_back(to_cell(*error));
    else
      column.cells.push_back(to_cell(key == title                        ? "scatter of the profile"
                                     : key == quantity::budget_state.key ? "one standard error"
                                                                         : ""));
  }
}

Table rim_table(const Study &study)
{
  const fem::RimCircle &circle = *study.glass.rim_circle;
  const auto length = [](double value, double error)
  { return error > 0 ? with_error(1e3 * value, 1e3 * error) : format::significant<6>(1e3 * value); };
  return words(
    "The rim, from the points of the profile", { "", "" },
    { { "contact radius (mm)", length(study.glass.profile.contact_radius, circle.contact_radius_error()) },
      { "crown radius (mm)", length(study.glass.profile.crown_radius, circle.crown_radius_error()) },
      { "points of the land", std::to_string(circle.points.size()) },
      { "their scatter, rms (µm)", format::significant<3>(1e6 * circle.scatter) },
      { "degrees of freedom", format::significant<3>(circle.freedom) } });
}

Json profile_summary(const Study &study)
{
  const GlassSection &glass = study.glass;
  Json summary = { { "points", glass.n_profile_points },
                   { "contact_radius", glass.profile.contact_radius },
                   { "crown_radius", glass.profile.crown_radius } };
  const fem::RimCircle *circle = glass.rim_circle.get();
  const bool scatters = scattered_circle(study);
  const auto if_scatters = [&](double value) { return scatters ? Json(value) : Json(nullptr); };
  summary["contact_radius_error"] = if_scatters(circle ? circle->contact_radius_error() : 0);
  summary["crown_radius_error"] = if_scatters(circle ? circle->crown_radius_error() : 0);
  summary["covariance"] = scatters ? Json(circle->covariance) : Json(nullptr);
  summary["scatter"] = circle && circle->freedom > 0 ? Json(circle->scatter) : Json(nullptr);
  summary["degrees_of_freedom"] = circle ? Json(circle->freedom) : Json(nullptr);
  summary["rim_points"] = circle ? circle->points.size() : 0;
  summary["repeated_points"] = circle ? circle->n_repeated : 0;
  summary["crown_determined"] = !circle || !crown_is_open(*circle);
  return summary;
}

Json profile_summary(const Study &study, const LoadReport &load, const std::optional<ProfileScatter> &scatter)
{
  Json summary = profile_summary(study);
  summary["sag_over_contact"] = sag_over_contact(study, load);
  if (const fem::RimCircle *circle = scattered_circle(study))
    summary["crown_determined"] = !crown_is_open(*circle) && !crown_is_below_scatter(study, *circle, load);
  const ProfileScatter known = scatter.value_or(ProfileScatter());
  summary["omega_terminal_error"] = json_number(known.spin);
  summary["omega_by_contact_radius"] = json_number(known.by_contact_radius);
  summary["omega_by_crown_radius"] = json_number(known.by_crown_radius);
  if (!known.reason.empty())
    summary["reason"] = known.reason;
  return summary;
}

} // namespace stemware::pipeline
