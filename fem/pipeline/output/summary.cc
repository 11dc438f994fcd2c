#include "fem/pipeline/output/summary.h"

#include "fem/pipeline/output/converge_results.h"

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

Json mesh_summary(const ContactFigures &contact)
{
  Json mesh = Json::object();
  if (contact.n_cells)
    mesh["cells"] = *contact.n_cells;
  if (contact.mesh_report)
  {
    mesh["round_rim"] = contact.mesh_report->round_rim;
    mesh["rim_radius"] = contact.mesh_report->rim_radius;
    mesh["land_area_deficit"] = contact.mesh_report->land_area_deficit;
  }
  return mesh;
}

Json contact_summary(const std::optional<ContactFigures> &contact)
{
  if (!contact)
    return nullptr;
  const fem::ContactSolution &solution = contact->result.solution;
  return { { "body", contact->body },
           { "friction_coupling", contact->friction_coupling },
           { "outcome", fem::to_string(solution.outcome) },
           { "mesh", mesh_summary(*contact) },
           { "unknowns", contact->n_unknowns },
           { "contact_nodes", contact->n_contact_nodes },
           { "loaded_nodes", solution.n_loaded_nodes },
           { "nodes_across", solution.n_nodes_across },
           { "iterations", solution.n_iterations },
           { "linear_iterations", solution.n_linear_iterations },
           { "force_residual", solution.force_residual },
           { "moment_residual", solution.moment_residual },
           { "equilibrium_residual", solution.equilibrium_residual },
           { "table_motion", { solution.motion(0), solution.motion(1), solution.motion(2) } } };
}

Json ring_summary(const Study &study, const StudyResult &result)
{
  const YawStudy &yaw = result.yaw;
  return { { "tau_at_rest", yaw.at_rest.torque },
           { "tau_closed_form", study.motion.orbit.friction_coefficient * result.load.moment.x() },
           { "omega_terminal", yaw.terminal.omega },
           { "time_constant", number_or_null(yaw.time_constant) },
           { "no_lift_off", result.load.moment_ratio <= 1 },
           { "moment_ratio_at_terminal", result.load.at_spin(yaw.terminal.omega).moment_ratio() },
           { "phase_dependent", result.phases.has_value() },
           { "spin_ripple", result.phases ? result.phases->spin_ripple : 0 } };
}

/// What an out-of-flat rim or table adds; null for flat ones.
Json waviness_summary(const std::optional<PhaseFigures> &phases)
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

Json coupling_summary(const std::shared_ptr<CouplingFigures> &coupling)
{
  if (!coupling)
    return nullptr;
  return { { "balanced_spins", coupling->n_balances },
           { "contact_solutions", coupling->n_contact_solutions },
           { "response_error", number_or_null(coupling->response_error) },
           { "interpolation_error", number_or_null(coupling->interpolation_error) } };
}

Json friction_summary(const fem::ResolvedFriction &resolved, const ring::Wrench &ring)
{
  return { { "torque", resolved.torque },
           { "force", { resolved.force_x, resolved.force_y } },
           { "ring_torque", ring.torque },
           { "ring_force", { ring.force_x, ring.force_y } } };
}

Json resolved_summary(const StudyResult &result)
{
  if (!result.contact)
    return nullptr;
  return { { "at_rest", friction_summary(result.contact->friction_at_rest, result.yaw.at_rest) },
           { "at_terminal",
             friction_summary(result.contact->friction_at_terminal, result.yaw.at_terminal) } };
}

Json truncation_summary(const std::vector<TruncationRow> &rows)
{
  Json table = Json::array();
  for (const TruncationRow &row : rows)
    table.push_back({ { "harmonics", row.harmonics },
                      { "tau_at_rest", row.tau_at_rest },
                      { "omega_terminal", row.omega_terminal },
                      { "relative_change", number_or_null(row.relative_change) },
                      { "bound", row.bound },
                      { "load_minimum", row.load_minimum } });
  return table;
}

Json closure_summary(const std::vector<ClosureRow> &rows)
{
  Json closures = Json::object();
  for (const ClosureRow &row : rows)
    closures[ring::to_string(row.closure)] = { { "tau_at_rest", row.tau_at_rest },
                                               { "omega_terminal", number_or_null(row.omega_terminal) },
                                               { "moment_ratio_at_rest", row.moment_ratio_at_rest },
                                               { "moment_ratio_at_terminal",
                                                 number_or_null(row.moment_ratio_at_terminal) },
                                               { "formal", row.is_formal() } };
  return closures;
}

} // namespace

nlohmann::ordered_json load_summary(const RingLoad &load)
{
  const ring::RingStack &series = load.at_rest;
  Json a = Json::array(), b = Json::array();
  for (unsigned int n = 0; n <= series.n_harmonics(); ++n)
  {
    a.push_back(series.a(n));
    b.push_back(series.b(n));
  }
  return { { "a", a },
           { "b", b },
           { "normal_force", load.normal_force },
           { "moment", { load.moment.x(), load.moment.y() } },
           { "moment_ratio", load.moment_ratio },
           { "ring_radius", series.radius() },
           { "mean_radius", load.mean_radius },
           { "contact_fraction", load.contact_fraction },
           { "minimum", load.minimum } };
}

Findings run_findings(const Study &study, const StudyResult &result)
{
  Findings findings;
  findings.summary = { { "load", load_summary(result.load) },
                       { "contact", contact_summary(result.contact) },
                       { "ring", ring_summary(study, result) },
                       { "coupling", coupling_summary(result.load.coupling) },
                       { "waviness", waviness_summary(result.phases) },
                       { "resolved", resolved_summary(result) },
                       { "truncation", truncation_summary(result.yaw.truncations) },
                       { "closures", closure_summary(result.closures) } };
  if (!result.error_bands.empty())
    findings.summary["error_bands"] = error_bands_as_json(result.error_bands);
  const TruncationRow &first = result.yaw.truncations.front();
  findings.key_figures = { { "tau_at_rest", result.yaw.at_rest.torque },
                           { "omega_terminal", result.yaw.terminal.omega },
                           { "omega_terminal_band",
                             number_or_null(band_of(result.error_bands, "omega_terminal")) },
                           { "omega_terminal_first_harmonic", first.omega_terminal },
                           { "relative_change", number_or_null(first.relative_change) } };
  return findings;
}

} // namespace stemware::pipeline
