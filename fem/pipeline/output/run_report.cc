#include "fem/pipeline/output/run_report.h"

#include "fem/pipeline/analysis/paper_spin_up.h"
#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/converge_report.h"
#include "fem/pipeline/output/harmonics_table.h"
#include "fem/pipeline/output/render/plots.h"
#include "fem/pipeline/output/study_sections.h"
#include "fem/pipeline/support/text_layout.h"

#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

std::string number(double value)
{
  return formatted("%.6g", value);
}

/// Six digits, and 0 for what is rounding beside @p scale.
std::string number(double value, double scale)
{
  return number(std::abs(value) < 1e-12 * scale ? 0 : value);
}

/// A terminal spin, with as many digits whatever they are.
std::string spin(double omega)
{
  return formatted("%#.6g", omega);
}

std::string spin(const std::optional<double> &omega)
{
  return omega ? spin(*omega) : "–";
}

std::string title(const Study &study)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return "Spin of a wine glass on the load of its elastic foot";
  case LoadSource::first_harmonic:
    return "Spin of a wine glass on a first-harmonic load";
  case LoadSource::file:
    return "Spin of a wine glass on a given load";
  }
  throw std::logic_error("a load source without a title");
}

/// From the paper's model to the study's, one step at a time.
ReportTable model_table(const Study &study, const StudyResult &result)
{
  const SpinComparison spins = compare_spins(study, result);
  ReportTable table = { "Terminal spin of the same glass in models of increasing detail",
                        { "load", "balance of moments", "terminal spin (rad/s)", "effect" },
                        {} };
  table.rows.push_back({ "first harmonic", "closure paper", spin(spins.paper_closure), "" });
  table.rows.push_back({ "first harmonic", "closure full", spin(spins.complete_closure),
                         "closure: " + in_percent(spins.closure_effect()) });
  const unsigned int n_harmonics = result.load.at_rest.n_harmonics();
  if (n_harmonics < 2)
    return table;
  const std::string own = study.load.source == LoadSource::file ? "given load"
                          : study.load.is_static()              ? "given moment"
                                                   : "closure " + ring::to_string(study.motion.closure);
  table.rows.push_back({ "first harmonic", own, spin(spins.first_harmonic), "" });
  table.rows.push_back({ "all " + std::to_string(n_harmonics) + " harmonics", own, spin(spins.all_harmonics),
                         "harmonics: " + in_percent(spins.harmonic_effect()) });
  return table;
}

ReportSection load_section(const StudyResult &result)
{
  const RingLoad &load = result.load;
  const ring::RingStack &series = load.at_rest;
  const double size = load.normal_force * series.radius();
  const std::string text =
    "What the glass puts on the table before it spins: N = " + number(load.normal_force) +
    " N with the moment M_N = (" + number(load.moment.x(), size) + ", " + number(load.moment.y(), size) +
    formatted(
      ") N m, a moment ratio m = |M_N| / (N R / 2) of %.4g. Above 1 a first-harmonic load would have to "
      "pull, at "
      "2 the glass tips. %.1f %% of the rim carries load; the least load is %.4g N/rad. The ring that stands "
      "for the foot has a radius of %.6g m.",
      load.moment_ratio, 100 * load.contact_fraction, load.minimum, series.radius());
  ReportSection section = {
    "The load on the table", text, { load_figure(series, {}) }, { harmonics_table(series) }
  };
  if (series.n_harmonics() > 1)
    section.figures.push_back(higher_harmonics_figure(series));
  section.figures.push_back(spectrum_figure(series, spectrum_band(result.error_bands, series.n_harmonics())));
  return section;
}

ReportTable friction_table(const Study &study, const StudyResult &result)
{
  const double force = study.motion.orbit.friction_coefficient * result.load.normal_force;
  const double torque = force * result.load.at_rest.radius();
  ReportTable table = { "Friction of the table on the glass", { "", "τ_z (N m)", "T_x (N)", "T_y (N)" }, {} };
  const auto add = [&](const std::string &name, const auto &friction)
  {
    table.rows.push_back({ name, number(friction.torque, torque), number(friction.force_x, force),
                           number(friction.force_y, force) });
  };
  add("ring, at rest", result.yaw.at_rest);
  add("ring, at the terminal spin", result.yaw.at_terminal);
  if (result.contact)
  {
    add("pressure where it lies, at rest", result.contact->friction_at_rest);
    add("pressure where it lies, at the terminal spin", result.contact->friction_at_terminal);
  }
  return table;
}

ReportSection spin_section(const Study &study, const StudyResult &result)
{
  const double omega = result.yaw.terminal.omega;
  std::string text = formatted(
    "Friction turns the glass at rest with τ_z = %.6g N m; μ M_Nx, which no harmonic beyond the first can "
    "change, is %.6g N m. The torque vanishes at the terminal spin ω = %.6g rad/s",
    result.yaw.at_rest.torque, study.motion.orbit.friction_coefficient * result.load.moment.x(), omega);
  if (result.yaw.time_constant)
    text +=
      formatted(", which the glass approaches with a time constant of %.4g s", *result.yaw.time_constant);
  const std::vector<SpinUp> curves = { { "all harmonics", result.spin_up.adaptive },
                                       { "first harmonic", result.spin_up.first_harmonic },
                                       SpinUp{ "the paper's model", paper_spin_up(study) } };
  return { "Torque and spin",
           text + ".",
           { torque_figure(result.torque, result.yaw.truncations),
             spin_up_figure(result.spin_up.time, curves) },
           { friction_table(study, result) } };
}

ReportSection truncation_section(const StudyResult &result)
{
  ReportTable table = { "The answer with the load cut off after some harmonics",
                        { "harmonics", "τ_z at rest (N m)", "terminal spin (rad/s)", "change of spin",
                          "bound on Δτ_z (N m)", "least load (N/rad)" },
                        {} };
  for (const TruncationRow &row : result.yaw.truncations)
    table.rows.push_back({ std::to_string(row.harmonics), formatted("%.7g", row.tau_at_rest),
                           formatted("%.8g", row.omega_terminal), in_percent(row.relative_change),
                           formatted("%.2e", row.bound), formatted("%.4g", row.load_minimum) });
  return { "How many harmonics matter",
           "The same load with fewer harmonics. The bound on the change of τ_z holds a priori, at the "
           "terminal spin of all harmonics. A "
           "truncated load whose least value is negative would have to pull.",
           { truncation_figure(result.yaw.truncations) },
           { table } };
}

ReportSection closure_section(const StudyResult &result)
{
  ReportTable table = { "A first-harmonic load in balance at every spin",
                        { "closure", "τ_z at rest (N m)", "terminal spin (rad/s)", "moment ratio at rest",
                          "at the terminal spin", "" },
                        {} };
  for (const ClosureRow &row : result.closures)
    table.rows.push_back(
      { ring::to_string(row.closure), number(row.tau_at_rest), spin(row.omega_terminal),
        formatted("%.4g", row.moment_ratio_at_rest),
        row.moment_ratio_at_terminal ? formatted("%.4g", *row.moment_ratio_at_terminal) : "–",
        row.is_formal() ? "formal" : "" });
  return { "Balances of moments",
           "The paper balances the centripetal part of the hand's force alone (closure paper). Closure hand "
           "takes the "
           "whole force of the hand, closure full adds the moment of the friction about the centre of mass. "
           "A formal load would have to pull on the table.",
           {},
           { table } };
}

ReportSection contact_section(const Study &study, const ContactFigures &contact)
{
  const fem::ContactSolution &solution = contact.result.solution;
  ReportTable table = { "", { "", "" }, {} };
  const auto add = [&](const std::string &name, const std::string &value) {
    table.rows.push_back({ name, value });
  };
  add("body", contact.body);
  if (contact.n_cells)
    add("cells", std::to_string(*contact.n_cells));
  add("unknowns", std::to_string(contact.n_unknowns));
  add("contact nodes", std::to_string(contact.n_contact_nodes));
  add("of them under load", std::to_string(solution.n_loaded_nodes));
  add("side by side across the contact", std::to_string(solution.n_nodes_across));
  add("outcome", fem::to_string(solution.outcome));
  add("Newton steps", std::to_string(solution.n_iterations));
  add("|Σf - N| / N", formatted("%.1e", solution.force_residual));
  add("|Σr×f - M_N| / (N R)", formatted("%.1e", solution.moment_residual));
  add("imbalance of the body's forces", formatted("%.1e", solution.equilibrium_residual));
  add("table moved by q_0 (m)", formatted("%.6g", solution.motion(0)));
  add("table tilted by q_1, q_2", formatted("%.6g, %.6g", solution.motion(1), solution.motion(2)));
  return { "The contact at rest",
           narrow_contact_remark(study, contact),
           { footprint_figure(contact.footprint, study.glass.profile.contact_radius) },
           { table } };
}

ReportSection file_section(const StudyResult &result, const std::filesystem::path &folder)
{
  ReportSection section = { "Files" };
  section.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study, to be run again" },
                    { "load.dat", "λ(θ) at rest" },
                    { "harmonics.dat", "its Fourier coefficients; Load/File reads them" },
                    { "torque.dat", "τ_z, T_x, T_y against the spin" },
                    { "spin_up.dat", "the spin against time" },
                    { "truncation.dat", "the answer after 1, 2, 3, 4, 6, 8 ... harmonics" } };
  if (result.contact)
    section.files.insert(section.files.end(),
                         { { "load_lines.dat", "λ(θ) at rest where the contact was solved" },
                           { "footprint.dat", "pressure p(r, θ) of the foot on the table at rest" },
                           { "contact_history.dat", "Newton steps of the contact" } });
  if (std::filesystem::exists(folder / "fields/contact.vtu"))
    section.files.push_back(
      { "fields/contact.vtu", "displacement, stress and contact pressure for ParaView" });
  section.files.push_back({ "timings.json", "how long it took" });
  return section;
}

} // namespace

Report run_report(const Study &study, const StudyResult &result, const std::filesystem::path &folder)
{
  Report report = { title(study), answer(study, result), {} };
  ReportSection models = { "What changes the spin" };
  models.tables = { model_table(study, result) };
  report.sections = { models, load_section(result), spin_section(study, result) };
  if (result.load.at_rest.n_harmonics() > 1)
    report.sections.push_back(truncation_section(result));
  report.sections.push_back(closure_section(result));
  if (result.contact)
    report.sections.push_back(contact_section(study, *result.contact));
  if (!result.error_bands.empty())
    report.sections.push_back(error_band_section(result.error_bands));
  for (const ReportSection &section : study_sections(study))
    report.sections.push_back(section);
  report.sections.push_back(file_section(result, folder));
  return report;
}

} // namespace stemware::pipeline
