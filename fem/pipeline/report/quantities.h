#pragma once

#include "fem/pipeline/report/render/table.h"

/// Names of the numbers in the results: key in summary.json, name in data files, unit, heading in reports,
/// label on the console, digits for people. What is empty is not shown there.
namespace stemware::pipeline::quantity
{

using namespace format;

// ---- rows: which load, with how many of its harmonics, under which moment balance
inline const Quantity closure("closure", "closure", "", "closure");
inline const Quantity load("load", "load", "", "load", "load");
inline const Quantity harmonics("harmonics", "harmonics", "1", "harmonics", "harmonics");
inline const Quantity all_harmonics("all_harmonics", "all harmonics", "");
inline const Quantity state("state", "state", "");
inline const Quantity message("message", "message", "");

// ---- the spin and its torque
inline const Quantity tau_at_rest("tau_at_rest", "tau_z at rest", "N m", "τ_z at rest", "torque at rest",
                                  significant<7>);
inline const Quantity omega_terminal("omega_terminal", "terminal omega", "rad/s", "terminal spin",
                                     "terminal spin", significant<8>);
inline const Quantity omega_terminal_band("omega_terminal_band", "", "rad/s");
inline const Quantity relative_change("relative_change", "relative change of terminal omega to all harmonics",
                                      "1", "change of spin", "change\nof spin", change);
inline const Quantity difference_to_paper("difference_to_paper", "relative difference to the paper", "1",
                                          "against the paper", "to the\npaper's", change, change_fixed);
inline const Quantity harmonic_effect("harmonic_effect", "harmonic effect", "rad/s", "harmonic effect",
                                      "harmonic\neffect", signed_significant<4>);
inline const Quantity harmonic_effect_relative("harmonic_effect_relative", "relative harmonic effect", "1",
                                               "harmonic effect", "harmonic\neffect", change);
inline const Quantity bound("bound", "a-priori bound on the change of tau_z at the terminal spin", "N m",
                            "bound on Δτ_z", "bound on torque", scientific_or_zero<2>, scientific_or_zero<3>);
inline const Quantity spin_up_deviation("spin_up_deviation",
                                        "largest deviation of omega(t) from all harmonics", "rad/s",
                                        "ω(t) off by", "omega(t) off by", scientific_or_zero<2>);
inline const Quantity spin_up_deviation_at_end("spin_up_deviation_at_end", "deviation of omega(t) at the end",
                                               "rad/s", "at the end", "", scientific_or_zero<2>);
/// The torque at the spin @p omega [rad/s], in a list of such.
inline Quantity torque_at(double omega)
{
  return { "torque[]", "tau_z at omega = " + significant<9>(omega) + " rad/s", "N m",
           "τ_z at " + significant<6>(omega) + " rad/s", "tau at " + significant<4>(omega) };
}

// ---- the budget: rows are models, from the paper's to the study's
inline const Quantity step_of_budget("step", "step", "", "step", "step");
inline const Quantity effect_name("name", "name", "");
inline const Quantity effect("title", "what is added", "", "what is added", "what is added");
inline const Quantity left_out("name", "without", "", "without", "without");
inline const Quantity spin_difference("difference", "difference of terminal omega", "rad/s", "difference",
                                      "difference", signed_significant<4>);
inline const Quantity relative_difference("relative_difference", "relative difference", "1", "relative",
                                          "relative", change);
inline const Quantity spin_band("band", "half-width of the error band of terminal omega", "rad/s", "band",
                                "band", format::band);
inline const Quantity budget_state("remark", "", "");
inline const Quantity formal_flag("formal", "1 if the load is negative somewhere");
inline const Quantity reason("reason", "", "");
/// tau_z at a @p place between rest and the complete model's terminal spin, in a list of such.
inline Quantity torque_of_budget(const std::string &place)
{
  return { "torques[]", "tau_z at " + place + " of the last row", "N m", place, place, significant<6> };
}

// ---- the load on the ring
inline const Quantity amplitude("amplitude", "amplitude of the highest one over a_0 at rest", "1",
                                "amplitude of the last / a_0", "last one\nover a_0", scientific<3>,
                                scientific<2>);
inline const Quantity load_minimum("load_minimum", "minimum of the load at rest", "N/rad", "least λ at rest",
                                   "least load\nat rest", significant<4>);
inline const Quantity load_minimum_at_terminal("load_minimum_at_terminal",
                                               "minimum of the load at the terminal spin", "N/rad",
                                               "least λ at the terminal spin", "", significant<4>);
inline const Quantity least_load("least_load", "", "N/rad", "least λ, at rest or at the terminal spin",
                                 "least load,\nrest or terminal", significant<4>);
inline const Quantity pulls("pulls", "1 if the load is negative somewhere");
inline const Quantity pulling_share("pulling_share", "share of N that would have to pull at rest");
inline const Quantity pulling_share_at_terminal("pulling_share_at_terminal",
                                                "share of N that would have to pull at the terminal spin");
inline const Quantity pulls_with("pulls_with", "", "1", "would have to pull (of N)", "pulls with\n(of N)",
                                 percent<3>, percent<2>);
inline const Quantity ring_radius_at_terminal("ring_radius_at_terminal", "ring radius at the terminal spin",
                                              "m");
inline const Quantity moment_ratio_at_rest("moment_ratio_at_rest", "moment ratio at rest", "1", "m at rest",
                                           "", significant<5>);
inline const Quantity moment_ratio_at_terminal("moment_ratio_at_terminal",
                                               "moment ratio at the terminal spin", "1",
                                               "m at the terminal spin", "", significant<5>);
inline const Quantity contact_fraction_at_terminal("contact_fraction_at_terminal",
                                                   "contact fraction at terminal omega", "1",
                                                   "rim that carries", "", percent_fixed<1>);
inline const Quantity formal("formal", "", "");
inline const Quantity load_at_terminal("load_at_terminal", "", "");

// ---- harmonics of a load
inline const Quantity harmonic("n", "n", "1", "n");
inline const Quantity cosine_share("a", "", "1", "a_n / a_0");
inline const Quantity sine_share("b", "", "1", "b_n / a_0");
inline const Quantity amplitude_share("amplitude", "", "1", "amplitude / a_0");
inline const Quantity crest("crest", "", "1", "largest at θ (degrees)", "", fixed<1>);

// ---- over the azimuth, the spin, the time, the phase
inline const Quantity theta("", "theta", "rad");
inline const Quantity lambda_all("", "lambda, all harmonics", "N/rad");
inline const Quantity lambda_first("", "lambda, first harmonic", "N/rad");
inline const Quantity lambda("", "lambda", "N/rad");
inline const Quantity load_over_mean("", "lambda / a_0");
inline const Quantity under_load("", "1 under load, nan elsewhere");
inline const Quantity omega("", "omega", "rad/s", "spin ω");
inline const Quantity slip_ratio("", "slip ratio omega R / v");
inline const Quantity tau_z("torque", "tau_z, all harmonics", "N m", "τ_z");
inline const Quantity lean_torque("lean_torque", "lean torque of the normal forces, all harmonics", "N m",
                                  "lean torque", "", significant<6>);
inline const Quantity grip_torque("grip_torque", "torque of the fingers", "N m", "torque of the fingers");
inline const Quantity torque_sum("torque_sum", "tau_z, lean torque and torque of the fingers together", "N m",
                                 "sum of the torques");
inline const Quantity force_x("force[]", "T_x", "N", "T_x");
inline const Quantity force_y("force[]", "T_y", "N", "T_y");
inline const Quantity time("", "time", "s", "time");
inline const Quantity omega_adaptive("", "omega, adaptive", "rad/s");
inline const Quantity omega_euler("", "omega, forward Euler", "rad/s");
inline const Quantity omega_first("", "omega, first harmonic alone, adaptive", "rad/s");
inline const Quantity yaw_angle("", "yaw angle, adaptive", "rad");
inline const Quantity mark_of_glass("", "mark of the glass", "rad");
inline const Quantity mark_of_table("", "mark of the table", "rad");
inline const Quantity tau_at_phase("", "tau_z at rest", "N m");
inline const Quantity tau_at_phase_in_the_long_run("", "tau_z at the mean spin in the long run", "N m");

// ---- the contact
inline const Quantity body("body", "", "", "body");
inline const Quantity friction_coupling("friction_coupling", "", "");
inline const Quantity outcome("outcome", "", "", "outcome");
inline const Quantity mesh("mesh", "", "");
inline const Quantity cells("", "", "1", "cells");
inline const Quantity unknowns("unknowns", "", "1", "unknowns");
inline const Quantity contact_nodes("contact_nodes", "", "1", "contact nodes");
inline const Quantity loaded_nodes("loaded_nodes", "", "1", "of them under load");
inline const Quantity nodes_across("nodes_across", "", "1", "side by side across the contact");
inline const Quantity iterations("iterations", "", "1", "Newton steps");
inline const Quantity linear_iterations("linear_iterations", "");
inline const Quantity force_residual("force_residual", "", "1", "|Σf - N| / N", "", scientific<1>);
inline const Quantity moment_residual("moment_residual", "", "1", "|Σr×f - M_N| / (N R)", "", scientific<1>);
inline const Quantity equilibrium_residual("equilibrium_residual", "", "1",
                                           "residual of the body's equilibrium", "", scientific<1>);
inline const Quantity table_heave("table_motion[]", "", "m", "table moved by q_0");
inline const Quantity table_tilt_1("table_motion[]", "", "rad", "table tilted by q_1");
inline const Quantity table_tilt_2("table_motion[]", "", "rad", "table tilted by q_2");
inline const Quantity step("", "step");
inline const Quantity step_active("", "loaded places");
inline const Quantity step_changed("", "changed places");
inline const Quantity step_residual("", "relative imbalance of forces");
inline const Quantity step_length("", "share of the step taken");
inline const Quantity step_linear_iterations("", "iterations of the linear solver");

// ---- error bands: rows are quantities, in units of their own
inline const Quantity quantity_key("key", "", "");
inline const Quantity quantity_name("quantity", "quantity", "", "quantity", "quantity");
inline const Quantity value("value", "value", "1", "value", "value", significant<9>);
inline const Quantity error_band("band", "band", "1", "band", "band", format::band);
inline const Quantity richardson("richardson", "Richardson value", "1", "Richardson value",
                                 "Richardson value", significant<9>);
inline const Quantity unit("unit", "unit", "", "unit", "unit");
inline const Quantity observed_order("order", "", "1", "observed order", "order", fixed<2>);

inline const Quantity mesh_level("", "level");
inline const Quantity mesh_correction("correction", "estimated error", "1", "estimated error",
                                      "estimated error", significant<3>);
inline const Quantity mesh_error("error", "error", "1", "error", "error", significant<3>);
inline const Quantity effectivity("effectivity", "estimated over true error", "1", "estimated / true error",
                                  "estimated / true", fixed<3>);

inline const Quantity refined("axis", "", "", "what is refined", "what is refined");
inline const Quantity unknowns_of_level("unknowns", "unknowns of the largest linear system, estimated");
inline const Quantity own_unknowns("unknowns", "", "1", "unknowns", "unknowns", about);
inline const Quantity finest_unknowns("finest", "", "1", "on the finest level", "finest", about);
inline const Quantity own_size("own", "", "", "the study has", "the study has");

// ---- sweeps
inline const Quantity case_number("", "case", "");
inline const Quantity case_outcome("", "contact outcome", "");
inline const Quantity case_status("", "status", "");
inline const Quantity values_found("values", "values", "", "samples");
inline const Quantity least("least", "", "1", "least", "least");
inline const Quantity least_case("least_case", "");
inline const Quantity most("most", "", "1", "most", "most");
inline const Quantity most_case("most_case", "");
inline const Quantity place_of_least("at_least", "", "", "at");
inline const Quantity place_of_most("at_most", "", "", "at");
inline const Quantity mean("mean", "mean", "", "mean", "mean");
inline const Quantity deviation("standard_deviation", "standard deviation", "", "standard deviation",
                                "standard\ndeviation", significant<3>, significant<6>);
inline const Quantity percentile_low("percentile_2.5", "2.5 % percentile", "", "2.5 %", "2.5 %");
inline const Quantity percentile_high("percentile_97.5", "97.5 % percentile", "", "97.5 %", "97.5 %");
inline const Quantity r_squared("r_squared", "r squared of the linear fit");
inline const Quantity entry("entry", "", "", "entry");
inline const Quantity regression("regression", "regression", "1", "standardised regression coefficient", "",
                                 fixed<3>);
inline const Quantity first_order("first_order", "first-order share", "1",
                                  "first-order share of the variance", "", fixed<3>);

// ---- axes of plots that are of no column, or in other units
namespace axis
{
inline constexpr char azimuth[] = "θ from the direction of travel (degrees)";
inline constexpr char distance_to_rim[] = "r - R (µm)";
inline constexpr char torque[] = "torque τ_z (mN m)";
inline constexpr char time[] = "t (s)";
inline constexpr char deviation[] = "|ω_n - ω_all| (rad/s)";
} // namespace axis

} // namespace stemware::pipeline::quantity
