#include "fem/pipeline/analysis/study_rows.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/curves.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>

namespace stemware::pipeline
{

namespace
{

/// Returns the answer @p row as a row of @p variant, with the number of harmonics of the variant even if its
/// load has fewer.
LoadedRow loaded_row(const Variant &variant, ring::Answer row, const std::optional<ring::Load> &load = {})
{
  if (variant.n_harmonics != all_harmonics)
    row.harmonics = variant.n_harmonics;
  return { variant, std::move(row), load, {} };
}

} // namespace

std::string grip_holds_note(double grip_torque, const ring::Answer &row)
{
  if (!row.terminal || !row.terminal->held || !row.at_rest)
    return "";
  const auto [torque, grip] = distinct_texts(std::abs(row.at_rest->friction.torque), grip_torque);
  return "The fingers hold the glass at rest: the torque at rest, " + torque +
         " N m, does not exceed Motion/Grip torque = " + grip + " N m.";
}

std::vector<unsigned int> truncation_orders(unsigned int n_all)
{
  std::vector<unsigned int> orders;
  for (unsigned int octave = 1; octave < n_all; octave *= 2)
    for (const unsigned int n : { octave, octave + octave / 2 })
      if (n < n_all && (orders.empty() || n > orders.back()))
        orders.push_back(n);
  orders.push_back(n_all);
  return orders;
}

ring::TimeObserver motion_observer(Progress &progress)
{
  using Clock = std::chrono::steady_clock;
  return [&progress, n_torques = std::size_t(0), last = Clock::time_point()](double time) mutable
  {
    constexpr std::size_t stride = 64; // a torque evaluation may be cheaper than reading the clock
    if (++n_torques % stride != 0)
      return;
    const Clock::time_point now = Clock::now();
    if (now - last < std::chrono::milliseconds(100))
      return;
    last = now;
    progress.pieces_done("torques of a motion, t = " + to_short_text(time) + " s", n_torques, 0);
  };
}

ring::Question spin_question(const Study &study, ring::Question question)
{
  question.motion = study.motion.orbit;
  question.grip_torque = study.motion.grip_torque;
  if (study.load.source != LoadSource::file)
    question.contact_radius = study.glass.profile.contact_radius;
  return question;
}

std::vector<LoadedRow> solve_rows(const std::vector<Variant> &variants,
                                  const std::shared_ptr<ElasticFoot> &foot, const ring::Question &asked,
                                  const Executor &executor, const std::optional<ring::Load> &of_study,
                                  const std::vector<double> &torque_spins)
{
  const auto solved_row = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &its_foot)
  {
    constexpr bool few_phases = true;
    const ring::Load load =
      variant.shared == Shared::load
        ? of_study->truncated(variant.n_harmonics)
        : find_load(variant.study, its_foot, silent_progress(), variant.n_harmonics, few_phases);
    ring::Question question = spin_question(variant.study, asked);
    // Variants with loads of their own are solved in parallel, where the observer must not be called.
    if (variant.shared != Shared::load)
      question.observer = {};
    LoadedRow row = loaded_row(variant, ring::answer(load, question), load);
    std::string reason;
    if (variant.is_of_chain())
      row.torques = ring::torque_curve(load, question, torque_spins, &reason);
    if (row.row.reason.empty())
      row.row.reason = reason;
    return row;
  };
  // Rows that use the load of the study share its cache of contact solutions. They are solved before the
  // other rows, one after another, because the cache must not be used by several threads.
  std::vector<LoadedRow> rows(variants.size());
  std::vector<Variant> others;
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].shared == Shared::load)
      rows[i] = solved_row(variants[i], foot);
    else
      others.push_back(variants[i]);
  const std::vector<Solved<LoadedRow>> solved =
    solve(others, foot, solved_row, executor, counting_callback(executor.progress, "models", others.size()));
  auto next = solved.begin();
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].shared != Shared::load)
    {
      rows[i] = next->answer ? *next->answer : loaded_row(variants[i], failed_row(next->failure));
      ++next;
    }
  return rows;
}

ring::Answer failed_row(const std::exception_ptr &failure)
{
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const fem::ContactFailure &contact)
  {
    const bool tips = contact.outcome == fem::ContactOutcome::tipping;
    return ring::failed_answer(tips ? std::make_exception_ptr(ring::Tipping(contact.what())) : failure);
  }
  catch (...)
  {
    return ring::failed_answer(failure);
  }
}

StudyRows rows_by_harmonics(const Analysis &analysis, const ring::Load &load, Depth depth,
                            const std::vector<Variant> &others)
{
  const auto &[study, foot, executor] = analysis;
  const bool is_slow = study.load.is_in_balance() && (study.is_collective() || study.has_waviness());
  std::vector<unsigned int> orders = truncation_orders(load.n_harmonics());
  if ((is_slow || depth == Depth::answer) && orders.size() > 2)
    orders = { 1, load.n_harmonics() };
  ring::Question question = spin_question(study);
  question.with_slope = true;
  question.observer = motion_observer(executor.progress);
  LoadedRow whole = { analysis.own(), ring::answer(load, question).value(), load };
  std::vector<double> torque_spins;
  if (depth == Depth::full)
  {
    const std::optional<double> omega = whole.row.omega_terminal();
    torque_spins = { 0 };
    if (omega)
      torque_spins.push_back(*omega / 2 + 0.); // + 0. avoids -0
    std::string reason;
    whole.torques = ring::torque_curve(load, question, torque_spins, &reason);
    if (whole.row.reason.empty())
      whole.row.reason = reason;
    if (omega)
    {
      // With waviness, the terminal spin is a mean over time, but at_terminal is the state at the zero of the
      // mean torque.
      torque_spins.push_back(*omega + 0.);
      whole.torques.push_back(*whole.row.at_terminal);
    }
  }
  question.with_slope = false;
  question.zero_guess = whole.row.zero_guess();
  // Models with fewer harmonics or effects probably tip near the spin at which the complete model tips.
  if (whole.row.fall)
    question.initial_guess = whole.row.fall->omega;
  std::vector<Variant> variants;
  for (std::size_t i = 0; i + 1 < orders.size(); ++i)
  {
    Variant &fewer =
      variants.emplace_back(Variant{ { study }, VariantKind::harmonics, std::to_string(orders[i]) });
    fewer.n_harmonics = orders[i];
    const bool has_own_balance =
      study.load.is_in_balance() &&
      (load.phases() || !ring::are_negligible_above(orders[i], whole.row, question.motion));
    fewer.shared = has_own_balance ? Shared::foot : Shared::load;
  }
  variants.insert(variants.end(), others.begin(), others.end());
  std::vector<LoadedRow> solved = solve_rows(variants, foot, question, executor, whole.load, torque_spins);
  StudyRows rows;
  const auto first_other = solved.begin() + static_cast<std::ptrdiff_t>(orders.size()) - 1;
  rows.by_harmonics.assign(std::make_move_iterator(solved.begin()), std::make_move_iterator(first_other));
  rows.others.assign(std::make_move_iterator(first_other), std::make_move_iterator(solved.end()));
  rows.by_harmonics.push_back(whole);
  for (LoadedRow &row : rows.by_harmonics)
    row.row = ring::compared_with_all(row.row, whole.row, load, question.motion);
  return rows;
}

} // namespace stemware::pipeline
