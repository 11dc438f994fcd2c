#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/study/study_file.h"

namespace stemware::pipeline
{

namespace
{

template <typename Value>
const Value *if_applies(bool applies, const Value &value)
{
  return applies ? &value : nullptr;
}

bool has_no_lift_off(const ContactReport &report)
{
  const auto pushes = [](const LoadReport &load) { return load.least >= 0 && load.contact_fraction >= 1; };
  return pushes(report.load) && pushes(report.load_at_end);
}

ring::Status status_of(const ContactReport &report, const SpinStudy &spin)
{
  const ring::Status status = spin.answer().status;
  if (status == ring::Status::full_contact && report.load_at_end.contact_fraction < 1)
    return ring::Status::lift_off;
  // With lift-off, the truncated Fourier series of the load is slightly negative outside the contact. The
  // pressure is not negative, so the status `formal` (tensile load) does not apply.
  return status == ring::Status::formal && report.foot ? ring::Status::lift_off : status;
}

/// Terminal spin. `from_rest` is true if the glass reaches this spin from rest.
struct SpinRow : ring::TerminalSpin
{
  bool from_rest;
};

std::vector<SpinRow> spins_of(const StudyAnswer &run)
{
  const auto &reached = run.spin.answer().terminal;
  std::vector<SpinRow> spins;
  for (const ring::TerminalSpin &one : run.spin.terminal_spins)
    spins.push_back({ one, reached && one.omega == reached->omega });
  return spins;
}

Fields<SpinRow> spin_fields()
{
  return { { "omega", "rad/s", "The spin.", &SpinRow::omega },
           { "stable", "", "Whether the spin is stable.", &SpinRow::stable },
           { "held", "", "Whether the fingers hold the glass at this spin.", &SpinRow::held },
           { "torque_slope", "N m s", "Derivative of the torque with respect to the spin.",
             [](const SpinRow &row) { return finite_or_null(row.torque_slope); } },
           { "time_constant", "s", "Time constant of the approach, or of the escape if unstable.",
             [](const SpinRow &row) { return finite_or_null(row.time_constant); } },
           { "from_rest", "", "Whether this spin is reached from rest.", &SpinRow::from_rest } };
}

Fields<StudyAnswer> driven_fields()
{
  using Start = ring::Breakaway;
  const auto start_fields =
    Fields<Start>{ { "time", "s", "Time at which the glass begins to slide.", &Start::time },
                   { "force", "N", "Force of the hand at that time.", &Start::force },
                   { "moment_ratio", "1", "Moment ratio of the load at that time.", &Start::moment_ratio },
                   { "friction_coefficient", "1", "Coefficient of friction at that time.",
                     [](const Start &start) { return start.motion.friction_coefficient; } } };
  const auto of_driven = [](auto member)
  { return [=](const StudyAnswer &run) { return (*run.spin.spin_up.driven).*member; }; };
  return {
    { "speed_at_end", "m/s", "Speed of the hand at the end.",
      [](const StudyAnswer &run) { return run.spin.spin_up.driven->speed.back(); } },
    { "omega_at_end", "rad/s", "Spin at the end.",
      [](const StudyAnswer &run) { return run.spin.spin_up.driven->omega.back(); } },
    { "interpolation_change", "rad/s", "Largest change of the spin under linear interpolation of the file.",
      of_driven(&DrivenSpinUp::interpolation_change) },
    { "interpolation_change_at_end", "rad/s",
      "Change of the spin at the end under linear interpolation of the file.",
      of_driven(&DrivenSpinUp::interpolation_change_at_end) },
    { "band_at_end", "rad/s",
      "Half-width of the error band of the spin at the end, from the integration and the mesh; null of a "
      "quick run.",
      [](const StudyAnswer &run) { return driven_band(run.spin, band_of(run.bands, "omega_terminal")); } },
    { "breakaway", "Start of sliding of a hand that starts from rest; else null.", start_fields,
      of_driven(&DrivenSpinUp::breakaway) }
  };
}

Fields<StudyAnswer> ring_fields()
{
  return Fields<StudyAnswer>{
    { "tau_closed_form", "N m",
      "μ M_N,x, the exact value of tau_at_rest; M_N is the mean over the phases with waviness, where "
      "load.moment is that of t = 0.",
      [](const StudyAnswer &run)
      {
        const double moment = run.spin.phases ? run.spin.answer().at_rest.value().load.moment().x()
                                              : run.contact.load.moment().x();
        return run.study.motion.orbit.friction_at_rest() * moment;
      } },
    { "standing", "", "Status at the terminal spin.",
      [](const StudyAnswer &run) { return to_string(status_of(run.contact, run.spin)); },
      of_type(
        { { "enum", { "full contact", "lift-off", "formal", "tips", "no balance", "no terminal spin" } } }) },
    { "terminal_spins", "All terminal spins within 1.5 v/R of rest.", spin_fields(), spins_of },
    { "driven", "Spin-up under Motion/Orbit speed file; else null.", driven_fields(),
      [](const StudyAnswer &run) { return if_applies(run.spin.spin_up.driven.has_value(), run); } },
    { "no_lift_off", "",
      "Whether the whole area of the land is under pressure and the load is nowhere negative, at rest "
      "and at the end of the spin-up.",
      [](const StudyAnswer &run) { return has_no_lift_off(run.contact); } },
    { "tilt_at_terminal", "rad", "Tilt of the glass about x and y at the terminal spin.",
      [](const StudyAnswer &run)
      {
        const Eigen::Vector2d &tilt = run.contact.load_at_end.tilt;
        return run.spin.answer().terminal ? std::optional(std::array<double, 2>{ tilt.x(), tilt.y() })
                                          : std::nullopt;
      } },
    { "phase_dependent", "", "Whether the load depends on the phase (waviness).",
      [](const StudyAnswer &run) { return run.spin.phases.has_value(); } },
    { "spin_ripple", "rad/s", "Amplitude of the spin's oscillation after the transient, if phase_dependent.",
      [](const StudyAnswer &run) { return run.spin.phases ? run.spin.phases->spin_ripple : 0; } }
  }.include(study_quantities(), [](const StudyAnswer &run) -> const StudyAnswer & { return run; });
}

Fields<PhaseStudy> waviness_fields()
{
  using Phases = PhaseStudy;
  return { { "spin_ripple", "rad/s", "Amplitude of the spin's oscillation after the transient.",
             &Phases::spin_ripple },
           { "spin_uncertainty", "rad/s", "Uncertainty of the mean spin, from the sampled phases.",
             &Phases::spin_uncertainty },
           { "zero_of_mean_torque", "rad/s", "Zero of the mean torque.", &Phases::zero_of_mean_torque },
           { "torque_ripple", "N m", "Amplitude of the torque over the phases.", &Phases::torque_ripple },
           { "least_load", "N/rad",
             "Minimum of the pointwise load over all phases, at rest and at the terminal spin.",
             &Phases::least_load },
           { "least_load_state", "", "State of least_load: \"at rest\" or \"at the terminal spin\".",
             [](const Phases &phases)
             { return std::string(phases.least_load_is_at_rest ? "at rest" : "at the terminal spin"); } },
           { "least_contact_fraction", "1", "Minimum of load.contact_fraction over all phases at rest.",
             &Phases::least_contact_fraction },
           { "glass_phases", "1", "Number of sampled phases of the glass.", &Phases::n_glass_phases },
           { "table_phases", "1", "Number of sampled phases of the table.", &Phases::n_table_phases },
           { "spins", "1", "Number of spins of the interpolant.", &Phases::n_spins },
           { "interpolation_error", "1", "Error of the interpolant, over a_0.",
             &Phases::interpolation_error } };
}

Fields<GlassSection> profile_fields()
{
  using Glass = GlassSection;
  return { { "points", "1", "Points of the profile.", &Glass::n_profile_points },
           { "contact_radius", "m", "Fitted or given value.",
             [](const Glass &glass) { return glass.profile.contact_radius; } },
           { "crown_radius", "m", "Fitted or given value.",
             [](const Glass &glass) { return glass.profile.crown_radius; } },
           { "rim_points", "1", "Number of points of the land in the fit of the circle.",
             [](const Glass &glass) { return glass.rim_circle ? glass.rim_circle->n_points : 0; } },
           { "rms_distance", "m", "RMS distance of the points from the circle; null if the rim is given.",
             [](const Glass &glass)
             { return glass.rim_circle ? std::optional(glass.rim_circle->rms_distance) : std::nullopt; } } };
}

Fields<StudyAnswer> coupling_fields()
{
  return { { "balanced_spins", "1", "Number of spins with solved balances.",
             [](const StudyAnswer &run) { return run.contact.coupling->n_balances; } },
           { "contact_solutions", "1", "Number of contacts solved for the balances.",
             [](const StudyAnswer &run) { return run.contact.coupling->n_contact_solutions; } },
           { "interpolation_error", "1", "Error of the interpolant over the spin, over a_0.",
             [](const StudyAnswer &run) { return run.spin.curve_error; } } };
}

/// Returns the part "mesh" of the band of the study's goal; std::nullopt without a goal or band.
std::optional<double> band_of_mesh(const StudyAnswer &answer)
{
  const auto banded = find_quantity(answer.bands, key_of(answer.study.contact.goal));
  if (banded == answer.bands.end() || banded->parts.count("mesh") == 0)
    return std::nullopt;
  return banded->parts.at("mesh");
}

Fields<StudyAnswer> goal_fields()
{
  const auto of_goal = [](auto member)
  { return [=](const StudyAnswer &run) { return (*run.goal).*member; }; };
  return { { "name", "", "The quantity of interest.",
             [](const StudyAnswer &run)
             { return study_as_json(entries_of(run.study))["Contact"]["Goal"].get<std::string>(); } },
           { "value", "", "Value in its unit.", of_goal(&GoalOutcome::value) },
           { "estimated_error", "", "Estimate of exact minus computed value.",
             of_goal(&GoalOutcome::estimated_error) },
           { "band_of_mesh", "", "Part of the error band that covers this error.", band_of_mesh },
           { "tolerance", "1", "Tolerance of the error, over the value.",
             [](const StudyAnswer &run) { return run.study.contact.goal_tolerance; } },
           { "meshes", "1", "Number of meshes.", of_goal(&GoalOutcome::n_meshes) },
           { "cells", "1", "Cells of the last mesh.", of_goal(&GoalOutcome::n_cells) },
           { "unknowns", "1", "Unknowns of the last mesh.",
             [](const StudyAnswer &run) { return run.contact.foot.value().foot.n_unknowns; } } };
}

} // namespace

Fields<StudyAnswer> run_fields()
{
  const auto one_ring_fields = Fields<ring::Answer>{
    { "tau_at_rest", "N m", "Torque of friction at rest.",
      [](const ring::Answer &answer)
      { return answer.at_rest ? std::optional(answer.at_rest->friction.torque) : std::nullopt; } },
    { "omega_terminal", "rad/s", "Terminal spin.", &ring::Answer::omega_terminal },
    { "relative_change", "1", "Relative change from several rings.", &ring::Answer::relative_change }
  };
  return Fields<StudyAnswer>{
    { "load_at_terminal", "The load at the terminal spin; null without one.", load_fields(),
      [](const StudyAnswer &run)
      { return if_applies(run.spin.answer().terminal.has_value(), run.contact.load_at_end); } },
    { "load_at_fall", "The load at the spin of tipping; null if the glass does not tip.", load_fields(),
      [](const StudyAnswer &run)
      { return if_applies(run.spin.answer().fall.has_value(), run.contact.load_at_end); } },
    { "contact", "The contact at rest; null for a load without a contact.", contact_fields(),
      [](const StudyAnswer &run) { return run.contact.foot ? &*run.contact.foot : nullptr; } },
    { "ring", "Torque and spin. Every tau_… is friction's torque about the glass's axis.", ring_fields(),
      [](const StudyAnswer &run) -> const StudyAnswer & { return run; } },
    { "coupling", "Statistics of the balances over the spin; null if the load does not depend on the spin.",
      coupling_fields(),
      [](const StudyAnswer &run) { return if_applies(run.contact.coupling.has_value(), run); } },
    { "waviness", "Results with waviness of rim or table; else null.", waviness_fields(),
      [](const StudyAnswer &run) { return run.spin.phases ? &*run.spin.phases : nullptr; } },
    { "budget", "The terminal spin from the paper's model to the study's, row by row; null in a quick run.",
      chain_fields(), [](const StudyAnswer &run) { return run.budget ? &run.budget->rows : nullptr; } },
    { "inputs", "Changes of the terminal spin by changed inputs; null in a quick run.", input_fields(),
      [](const StudyAnswer &run) { return run.budget ? &run.budget->inputs : nullptr; } },
    { "without", "The complete model without one effect at a time; null in a quick run.", without_fields(),
      [](const StudyAnswer &run) { return run.budget ? &run.budget->without : nullptr; } },
    { "one_ring", "The answer with all harmonics on one ring; null in a quick run.", one_ring_fields,
      [](const StudyAnswer &run) { return run.spin.one_ring; } },
    { "error_bands", "Error bands by quantity; null in a quick run and if none could be estimated.",
      band_fields(false), [](const StudyAnswer &run) { return if_applies(!run.bands.empty(), run.bands); } },
    { "profile", "Results for Glass/Shape = profile.", profile_fields(),
      [](const StudyAnswer &run)
      { return if_applies(run.study.glass.profile.section != nullptr, run.study.glass); },
      or_absent() },
    { "goal", "With Contact/Goal.", goal_fields(),
      [](const StudyAnswer &run) { return if_applies(run.goal.has_value(), run); }, or_absent() }
  }.include(harmonics_fields(), [](const StudyAnswer &run) -> const StudyAnswer & { return run; });
}

Fields<FootReport> contact_fields()
{
  using Foot = FootReport;
  using Mesh = fem::MeshReport;
  const auto of_mesh = [](auto member)
  {
    return [=](const fem::FootDescription &foot)
    { return foot.mesh_report ? std::optional(*foot.mesh_report.*member) : std::nullopt; };
  };
  const auto of_foot = [](auto member) { return [=](const Foot &report) { return report.foot.*member; }; };
  const auto of_solution = [](auto member)
  { return [=](const Foot &report) { return report.at_rest.solution.*member; }; };
  const auto n_cells = [](const fem::FootDescription &foot) { return foot.n_cells; };
  const auto mesh_fields = Fields<fem::FootDescription>{
    { "cells", "1", "Number of hexahedra.", n_cells, or_absent() },
    { "round_rim", "", "Whether the rim of a mesh file is round.", of_mesh(&Mesh::round_rim), or_absent() },
    { "rim_radius", "m",
      "Contact radius of the land: mean of the smallest and largest distance of the land's border from "
      "the axis.",
      of_mesh(&Mesh::rim_radius), or_absent() },
    { "land_area_deficit", "1", "Share of the land's area that straight edges cut off.",
      of_mesh(&Mesh::land_area_deficit), or_absent() }
  };
  using Description = fem::FootDescription;
  using Solution = fem::ContactSolution;
  return { { "body", "", "revolution or solid.", of_foot(&Description::body), on_page("body") },
           { "cells", "1", "", of_foot(&Description::n_cells), on_page("cells") },
           { "friction_coupling", "", "Whether friction deforms the foot: elastic or none.",
             &Foot::friction_coupling },
           { "mesh", "Mesh of a solid body.", mesh_fields, &Foot::foot },
           { "unknowns", "1", "Unknowns of the largest linear system.", of_foot(&Description::n_unknowns),
             on_page("unknowns") },
           { "contact_nodes", "1", "Nodes that may touch the table.", of_foot(&Description::n_contact_nodes),
             on_page("contact nodes") },
           { "loaded_nodes", "1", "Contact nodes under load.", of_solution(&Solution::n_loaded_nodes),
             on_page("of them under load") },
           { "nodes_across", "1", "Largest number of neighbouring loaded nodes across the rim.",
             of_solution(&Solution::n_nodes_across), on_page("side by side across the contact") },
           { "outcome", "", "Outcome of the solution: converged, or narrow contact.",
             [](const Foot &report) { return std::string(fem::to_string(report.at_rest.solution.outcome)); },
             on_page("outcome") },
           { "iterations", "1", "Newton steps.", of_solution(&Solution::n_iterations),
             on_page("Newton steps") },
           { "linear_iterations", "1", "Iterations of the linear solver.",
             of_solution(&Solution::n_linear_iterations) },
           { "force_residual", "1", "|Σf − N| / N.", of_solution(&Solution::force_residual),
             on_page("|Σf - N| / N"), with_digits("#.1e") },
           { "moment_residual", "1", "|Σ r×f − M_N| / (N R).", of_solution(&Solution::moment_residual),
             on_page("|Σr×f - M_N| / (N R)"), with_digits("#.1e") },
           { "equilibrium_residual", "1", "Residual of the body's equilibrium.",
             of_solution(&Solution::equilibrium_residual), on_page("residual of the body's equilibrium"),
             with_digits("#.1e") },
           { "table_motion", "", "Motion of the table: q_0 (m), q_1 and q_2 (rad).",
             [](const Foot &report)
             {
               const Eigen::Vector3d &motion = report.at_rest.solution.motion;
               return std::array<double, 3>{ motion(0), motion(1), motion(2) };
             },
             with_places({ { "", "m", "", "", "", "table moved by q_0" },
                           { "", "rad", "", "", "", "table tilted by q_1" },
                           { "", "rad", "", "", "", "table tilted by q_2" } }) } };
}

} // namespace stemware::pipeline
