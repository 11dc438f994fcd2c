#pragma once

#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made.h"

namespace stemware::test
{

/// A quantity with its band.
inline pipeline::BandedQuantity hand_made_band(Numbers &next, const std::string &key, const std::string &name,
                                               const std::string &unit)
{
  const double value = next();
  return { { key, name, unit, value, 1e-9 }, next() / 1000, next() };
}

/// The value of a harmonic that symmetry forbids.
inline pipeline::BandedQuantity zero_band(const std::string &key)
{
  return { { key, key, "1", 0, 1e-9 }, 0, 0 };
}

inline pipeline::TorqueCurve hand_made_torque_curve(Numbers &next)
{
  pipeline::TorqueCurve curve;
  curve.omega = { -next(), next() };
  curve.slip_ratio = { next(), next() };
  curve.friction = { { next(), next(), next() }, { next(), next(), next() } };
  curve.lean_torque = { 0.015, 0.025 };
  curve.grip_torque = { 0.035, -0.045 };
  for (std::size_t i = 0; i < 2; ++i)
    curve.sum.push_back(curve.friction[i].torque + curve.lean_torque[i] + curve.grip_torque[i]);
  curve.harmonics = { 1 };
  curve.truncations = { { next(), next() } };
  return curve;
}

/// Every kind of row: the second is formal, and the one with tilt has no balance.
inline pipeline::Budget hand_made_budget(Numbers &next)
{
  pipeline::Budget budget;
  const auto add =
    [&](const pipeline::ChainStep &step, const char *name, std::optional<unsigned int> harmonics)
  {
    pipeline::BudgetRow row = { step, name, harmonics };
    row.omega_terminal = -next();
    if (!budget.rows.empty())
      row.difference = *row.omega_terminal - budget.rows.back().omega_terminal.value_or(-1);
    row.band = next() / 1000;
    row.torques = { next(), next(), next() };
    row.status = ring::Status::full_contact;
    budget.rows.push_back(row);
  };
  add({ 1 }, "paper", 1);
  add({ 2 }, "moment balance", 1);
  budget.rows.back().status = ring::Status::formal;
  add({ 2, true }, "grip", 1);
  add({ 3 }, "where the foot touches", 1);
  budget.rows.push_back({ { 3, true }, "tilt", 1 });
  budget.rows.back().status = ring::Status::tips;
  budget.rows.back().reason = "The foot tips";
  add({ 4 }, "harmonics", 2);
  budget.rows.back().difference.reset();
  add({ 5 }, "harmonics", {});
  budget.without = { { "tilt", -next(), next() / 100, "" },
                     { "elasticity of the foot", -next(), -next() / 100, "" },
                     { "compliance of the interface", {}, {}, "not defined" } };
  budget.harmonics = { -next() / 100, next() / 1000 };
  budget.shown_spins = { 0, -next(), -next() };
  for (int i = 0; i < 5; ++i) // numbers that no budget has
    next();
  return budget;
}

/// Effects of one and of two harmonics whose numbers are all different. Torque at rest: 2 N m.
inline ring::TorqueEffects hand_made_effects()
{
  using AtSpin = ring::TorqueEffect::AtSpin;
  return { 2,
           { 0, -4 },
           { { 1, AtSpin{ 0, 0.25, 0.3125 }, AtSpin{ 0, 0.375, 0.4375 }, 0, 0, { 0, 0 } },
             { 2, AtSpin{ 0.25, 0, 0 }, AtSpin{ 0.375, 0, 0 }, 0.5, -3, { 0, 0.375 } } } };
}

struct RunByHand : pipeline::StudyAnswer
{
  RunByHand()
  {
    Numbers next;
    contact.load = hand_made_load_report(next);
    contact.foot = pipeline::FootReport();
    contact.coupling = pipeline::CouplingStatistics();
    pipeline::FootReport &foot = *contact.foot;
    foot.foot = { "solid", 101, 102, 103, fem::MeshReport() };
    foot.foot.mesh_report->rim_radius = next();
    foot.foot.mesh_report->land_area_deficit = next();
    foot.friction_coupling = "none";
    fem::ContactSolution &solution = foot.at_rest.solution;
    solution.outcome = fem::ContactOutcome::narrow_contact;
    solution.n_loaded_nodes = 104;
    solution.n_nodes_across = 105;
    solution.n_iterations = 106;
    solution.n_linear_iterations = 107;
    solution.force_residual = next() * 1e-10;
    solution.moment_residual = next() * 1e-11;
    solution.equilibrium_residual = next() * 1e-12;
    solution.motion = { next(), next(), next() };
    foot.at_rest.history = { { 1, 201, 202, next(), next(), 203 }, { 2, 204, 205, next(), next(), 206 } };
    foot.footprint.is_grid = true;
    foot.footprint.cuts = { { { next(), 0.25, next() }, { next(), 0.25, next() } } };
    foot.fields = { { "contact.vtu", "" } };
    next();
    *contact.coupling = { 301, 302 };
    spin.curve_error = next();
    spin.rows = { hand_made_row(next, 1), hand_made_row(next, 2) };
    spin.torque = hand_made_torque_curve(next);
    spin.torque_effects = hand_made_effects();
    spin.spin_up = {
      { 0, next() }, { 0, next() }, { 0, next() }, { 0, next() }, { 0, next() }, { 0, next() }
    };
    spin.phases = pipeline::PhaseStudy{
      next(),     next(),    next(), next(), next(), next(), 401, 402, 403, next(), { { next(), next() } },
      { next() }, { next() }
    };
    bands = { zero_band("a1"), hand_made_band(next, "b1", "b_1/a_0", "1"),
              hand_made_band(next, "a2", "a_2/a_0", "1"), zero_band("b2"),
              hand_made_band(next, "omega_terminal", "terminal spin", "rad/s") };
    study.table.waviness.push_back({});
    contact.load_at_end = hand_made_load_report(next);
    contact.load_at_end.tilt = { next(), next() };
    contact.load.outer_radius = contact.load.inner_radius + 2 * next() / 1000;
    spin.budget = hand_made_budget(next);
    bands.back().parts = { { "mesh", next() / 1e4 }, { "rings", next() / 1e4 } };
    study.load.coupling = pipeline::LoadCoupling::one_way;
  }
};

inline pipeline::Results made_run()
{
  return run_results(RunByHand());
}

struct RefinementByHand
{
  RefinementByHand()
  {
    Numbers next;
    bands.push_back(hand_made_band(next, "b2", "b_2/a_0", "1"));
    bands.push_back(hand_made_band(next, "omega_terminal", "terminal spin", "rad/s"));
    pipeline::RefinementAxis axis = { "meridional_mesh", "meridional mesh", "halvings of every cell" };
    axis.sizes = { 0, 1 };
    axis.levels.resize(2);
    axis.own = 1;
    for (const pipeline::BandedQuantity &banded : bands)
      axis.quantities.push_back(
        { { next(), next() }, next(), next(), { next() / 1000, next() / 1000 }, banded.quantity.key });
    axes.push_back(axis);
  }

  std::vector<pipeline::RefinementAxis> axes;
  pipeline::ErrorBands bands;
};

} // namespace stemware::test
