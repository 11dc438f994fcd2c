#include "fem/pipeline/output/run_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/common_sections.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/output/run_tables.h"
#include "fem/pipeline/output/spin_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// Terminal spin and torque by the number of harmonics.
Table truncation_table(const SpinStudy &spin,
                       const std::string &title = "The answer with the load cut off after some harmonics")
{
  return spin_table(spin.rows).with(
    title, "harmonics tau_at_rest omega_terminal relative_change bound load_minimum");
}

/// A first-harmonic load under each moment balance.
Table closure_table(const SpinStudy &spin)
{
  Table table = spin_table(spin.closures)
                  .with("A first-harmonic load in balance at every spin",
                        "closure tau_at_rest omega_terminal moment_ratio_at_rest moment_ratio_at_terminal "
                        "formal");
  table["tau_at_rest"].digits = format::significant<6>;
  table["omega_terminal"].digits = format::all_significant<6>;
  table["moment_ratio_at_rest"].digits = table["moment_ratio_at_terminal"].digits = format::significant<4>;
  table["moment_ratio_at_rest"].heading = "moment ratio at rest";
  table["moment_ratio_at_terminal"].heading = "at the terminal spin";
  return table;
}

// ---- summary.json

Json closure_summary(const SpinStudy &spin)
{
  Table table =
    spin_table(spin.closures)
      .with("", "closure tau_at_rest omega_terminal moment_ratio_at_rest moment_ratio_at_terminal pulls");
  table["pulls"].key = "formal";
  return json_by_name(table);
}

Json ring_summary(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  return { { "tau_at_rest", all.at_rest.value().friction.torque },
           { "tau_closed_form", study.motion.orbit.friction_coefficient * report.load.moment.x() },
           { "omega_terminal", all.omega_terminal().value() },
           { "time_constant", json_number(all.time_constant()) },
           { "no_lift_off", report.load.moment_ratio <= 1 },
           { "moment_ratio_at_terminal", all.at_terminal.value().moment_ratio },
           { "phase_dependent", spin.phases.has_value() },
           { "spin_ripple", spin.phases ? spin.phases->spin_ripple : 0 } };
}

/// What an out-of-flat rim or table adds; null for flat ones.
Json waviness_summary(const std::optional<PhaseStudy> &phases)
{
  if (!phases)
    return nullptr;
  return { { "spin_ripple", phases->spin_ripple },
           { "spin_uncertainty", phases->spin_uncertainty },
           { "zero_of_mean_torque", phases->zero_of_mean_torque },
           { "torque_ripple", phases->torque_ripple },
           { "least_load", phases->least_load },
           { "least_contact_fraction", phases->least_contact_fraction },
           { "glass_phases", phases->n_glass_phases },
           { "table_phases", phases->n_table_phases },
           { "spins", phases->n_spins },
           { "interpolation_error", phases->interpolation_error } };
}

Json coupling_summary(const std::optional<CouplingStatistics> &coupling)
{
  if (!coupling)
    return nullptr;
  return { { "balanced_spins", coupling->n_balances },
           { "contact_solutions", coupling->n_contact_solutions },
           { "response_error", json_number(coupling->response_error) },
           { "interpolation_error", json_number(coupling->interpolation_error) } };
}

/// Friction of the pressure field beside that of the ring; null without a contact.
Json resolved_summary(const ContactReport &report, const Table &friction)
{
  if (!report.foot)
    return nullptr;
  const auto row = [&](std::size_t field, std::size_t ring)
  {
    const Table numbers = friction.with("", "torque force[]");
    Json object = json_row(numbers, field);
    const Json on_ring = json_row(numbers, ring);
    object["ring_torque"] = on_ring["torque"];
    object["ring_force"] = on_ring["force"];
    return object;
  };
  return { { "at_rest", row(2, 0) }, { "at_terminal", row(3, 1) } };
}

Findings findings_of(const Study &study, const ContactReport &report, const SpinStudy &spin,
                     const std::vector<BandedQuantity> &bands)
{
  Findings findings;
  findings.summary = { { "load", load_summary(report.load) },
                       { "contact", report.foot ? json_row(contact_table(*report.foot)) : Json(nullptr) },
                       { "ring", ring_summary(study, report, spin) },
                       { "coupling", coupling_summary(report.coupling) },
                       { "waviness", waviness_summary(spin.phases) },
                       { "resolved", resolved_summary(report, friction_table(study, report, spin.all())) },
                       { "truncation", json_table(truncation_table(spin)) },
                       { "closures", closure_summary(spin) } };
  if (!bands.empty())
    findings.summary["error_bands"] = json_by_name(band_table(bands).with("", "key value band unit"));
  const SpinRow &first = spin.rows.front();
  findings.key_figures = { { "tau_at_rest", spin.all().at_rest.value().friction.torque },
                           { "omega_terminal", spin.all().omega_terminal().value() },
                           { "omega_terminal_band", json_number(band_of(bands, "omega_terminal")) },
                           { "omega_terminal_first_harmonic", json_number(first.omega_terminal()) },
                           { "relative_change", json_number(first.relative_change) } };
  return findings;
}

// ---- report

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
Table model_table(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const auto spin_cell = [](const std::optional<double> &omega)
  { return omega ? format::all_significant<6>(*omega) : "–"; };
  const auto effect_cell = [](const std::string &name, const std::optional<double> &effect)
  { return name + ": " + (effect ? format::change(*effect) : "–"); };
  const SpinComparison spins = compare_spins(study, spin);
  std::vector<std::vector<std::string>> rows = {
    { "first harmonic", "closure paper", spin_cell(spins.paper_closure), "" },
    { "first harmonic", "closure full", spin_cell(spins.complete_closure),
      effect_cell("closure", spins.closure_effect()) }
  };
  if (const unsigned int n_harmonics = report.load.rings.n_harmonics(); n_harmonics > 1)
  {
    const std::string own = study.load.source == LoadSource::file ? "given load"
                            : study.load.is_static()              ? "given moment"
                                                     : "closure " + ring::to_string(study.motion.closure);
    rows.push_back({ "first harmonic", own, spin_cell(spins.first_harmonic), "" });
    rows.push_back({ "all " + std::to_string(n_harmonics) + " harmonics", own, spin_cell(spins.all_harmonics),
                     effect_cell("harmonics", spins.harmonic_effect()) });
  }
  return words("Terminal spin of the same glass in models of increasing detail",
               { "load", "moment balance", heading_with_unit(quantity::omega_terminal), "effect" }, rows);
}

/// Bands of the amplitudes sqrt(a_n^2 + b_n^2) / a_0, n = 0 ... @p n_harmonics, 0 beyond those that are
/// followed; empty without bands.
std::vector<double> spectrum_band(const std::vector<BandedQuantity> &bands, unsigned int n_harmonics)
{
  if (bands.empty())
    return {};
  std::vector<double> widths(n_harmonics + 1, 0);
  for (unsigned int n = 1; n <= std::min(n_harmonics, n_harmonics_of_interest); ++n)
    widths[n] = std::hypot(band_of(bands, "a" + std::to_string(n)).value(),
                           band_of(bands, "b" + std::to_string(n)).value());
  return widths;
}

ReportSection load_section(const LoadReport &load, const std::vector<BandedQuantity> &bands)
{
  const ring::RingStack &rings = load.rings;
  const double rounding = 1e-12 * load.normal_force * rings.radius();
  const auto moment = [=](double value)
  { return format::significant<6>(std::abs(value) < rounding ? 0 : value); };
  ReportSection section = {
    "The load on the table",
    fmt::format(
      FMT_STRING(
        "Before the glass spins it presses on the table with N = {:.6g} N and the moment M_N = ({}, "
        "{}) N m, a moment ratio m = |M_N| / (N R / 2) of {:.4g}. Above 1 a first-harmonic load would "
        "have to pull, at 2 the glass tips. {:.1f} % of the rim carries load; the least load is "
        "{:.4g} N/rad. The equivalent ring, with the same N, M_N and first harmonic, has a radius of "
        "{:.6g} m."),
      load.normal_force, moment(load.moment.x()), moment(load.moment.y()), load.moment_ratio,
      100 * load.contact_fraction, load.minimum, rings.radius()),
    { load_plot(rings, {}) },
    { harmonics_table(rings) }
  };
  if (rings.n_harmonics() > 1)
    section.plots.push_back(higher_harmonics_plot(rings));
  section.plots.push_back(spectrum_plot(rings, spectrum_band(bands, rings.n_harmonics())));
  return section;
}

ReportSection spin_section(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  std::string text = fmt::format(
    FMT_STRING("Friction turns the glass at rest with τ_z = {:.6g} N m; μ M_Nx, which no harmonic beyond the "
               "first can change, is {:.6g} N m. The torque vanishes at the terminal spin ω = {:.6g} rad/s"),
    all.at_rest.value().friction.torque, study.motion.orbit.friction_coefficient * report.load.moment.x(),
    all.omega_terminal().value());
  if (const auto time_constant = all.time_constant())
    text +=
      ", which the glass approaches with a time constant of " + format::significant<4>(*time_constant) + " s";
  const SpinUpCurves &curves = spin.spin_up;
  return { "Torque and spin",
           text + ".",
           { torque_plot(spin.torque, spin.rows),
             spin_up_plot({ { "all harmonics", curves.time, curves.adaptive },
                            { "first harmonic", curves.time, curves.first_harmonic },
                            { "the paper's model", curves.time, curves.paper } }) },
           { friction_table(study, report, all) } };
}

ReportSection truncation_section(const SpinStudy &spin)
{
  return { "Fewer harmonics",
           "The torque at rest is that of the first harmonic. The terminal spin is that of the ring under "
           "the load with fewer harmonics. The bound on the change of τ_z holds a priori, at the terminal "
           "spin of all harmonics. A truncated load whose least value is negative would have to pull.",
           { truncation_plot(spin.rows) },
           { truncation_table(spin) } };
}

ReportSection closure_section(const SpinStudy &spin)
{
  return { "Moment balances",
           "The paper balances the centripetal part of the hand's force alone (closure paper). Closure hand "
           "takes the whole force of the hand, closure full adds the moment of the friction about the centre "
           "of mass. A formal load would have to pull on the table.",
           {},
           { closure_table(spin) } };
}

ReportSection contact_section(const Study &study, const FootReport &foot)
{
  Table numbers = contact_table(foot).with(
    "", "body unknowns contact_nodes loaded_nodes nodes_across outcome iterations force_residual "
        "moment_residual equilibrium_residual table_motion[]");
  if (foot.foot.n_cells)
    numbers.columns.insert(numbers.columns.begin() + 1, single(quantity::cells, *foot.foot.n_cells));
  return { "The contact at rest",
           narrow_contact_remark(study, foot),
           { footprint_plot(foot.footprint, study.glass.profile.contact_radius) },
           { as_list(numbers) } };
}

std::vector<ResultFile> files_of(const ContactReport &report, const SpinStudy &spin)
{
  Table truncations = truncation_table(spin);
  truncations["relative_change"].name += ", nan where that is 0";
  std::vector<ResultFile> files = {
    { "summary.json", "all numbers, for programs" },
    { "parameters.prm", "the study, to be run again" },
    { "load.dat", "λ(θ) at rest", load_table(report.load.rings) },
    { "harmonics.dat", "its Fourier coefficients; Load/File reads them", load_file_text(report.load.rings) },
    { "torque.dat", "τ_z, T_x, T_y against the spin", torque_table(spin.torque) },
    { "spin_up.dat", "the spin against time", spin_up_table(spin.spin_up, report.coupling) },
    { "truncation.dat", "the answer after 1, 2, 3, 4, 6, 8 ... harmonics", truncations }
  };
  if (spin.phases)
    files.push_back({ "phases.dat", "τ_z by the orientation of glass and table", phase_table(*spin.phases) });
  if (const auto &foot = report.foot)
  {
    files.push_back({ "load_lines.dat", "λ(θ) at rest where the contact was solved",
                      pointwise_table(report.load.pointwise) });
    files.push_back({ "footprint.dat", "pressure p(r, θ) of the foot on the table at rest",
                      footprint_text(foot->footprint) });
    files.push_back(
      { "contact_history.dat", "Newton steps of the contact", history_table(foot->at_rest.history) });
    const auto is_whole = [](const fem::FieldFile &file) { return file.name == "contact.vtu"; };
    if (std::any_of(foot->fields.begin(), foot->fields.end(), is_whole))
      files.push_back({ "fields/contact.vtu", "displacement, stress and contact pressure for ParaView" });
  }
  files.push_back({ "timings.json", "how long it took" });
  return files;
}

Report report_of(const Study &study, const ContactReport &contact, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::vector<ResultFile> &files)
{
  Report report = { title(study),
                    run_answer(study, contact, spin, bands),
                    { { "What changes the spin", "", {}, { model_table(study, contact, spin) } },
                      load_section(contact.load, bands),
                      spin_section(study, contact, spin) } };
  if (contact.load.rings.n_harmonics() > 1)
    report.sections.push_back(truncation_section(spin));
  report.sections.push_back(closure_section(spin));
  if (contact.foot)
    report.sections.push_back(contact_section(study, *contact.foot));
  if (!bands.empty())
    report.sections.push_back(error_band_section(bands));
  add_closing_sections(report, study, files);
  return report;
}

} // namespace

Results tabulate(const Study &study, const ContactReport &report, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands)
{
  Results results;
  results.files = files_of(report, spin);
  results.report = report_of(study, report, spin, bands, results.files);
  results.console = { { joined({ results.report.answer, lift_off_remark(report.load),
                                 narrow_contact_remark(study, report.foot),
                                 waviness_remark(study, spin.phases) }) },
                      { "", truncation_table(spin, "") } };
  results.findings = findings_of(study, report, spin, bands);
  if (report.foot)
    results.fields = report.foot->fields;
  return results;
}

} // namespace stemware::pipeline
