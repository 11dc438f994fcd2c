#include "fem/pipeline/analysis/study_rows.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/spin/if_balanced.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>

namespace stemware::pipeline
{

namespace
{

/// Numbers of harmonics of the rows.
std::vector<unsigned int> row_orders(const Study &study, unsigned int n_all, Depth depth)
{
  const bool is_slow =
    study.load.is_in_balance() && (abilities(study.contact.body).is_collective || study.has_waviness());
  if ((is_slow || depth == Depth::answer) && n_all > 1)
    return { 1, n_all };
  return truncation_orders(n_all);
}

/// The load of @p variant on its @p foot, whose terminal spin is believed to be where @p asked has it.
SharedLoad load_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                   const ring::Question &asked)
{
  const std::optional<double> expected = asked.near                 ? std::optional(asked.near->omega)
                                         : asked.initial_guess != 0 ? std::optional(asked.initial_guess)
                                                                    : std::nullopt;
  return find_load(variant.study, foot, silent_progress(), variant.n_harmonics, expected,
                   PhaseSampling::coarse);
}

} // namespace

double spin_unit(const Study &study)
{
  return study.motion.orbit.orbit_speed / study.glass.profile.contact_radius;
}

double spin_scale(const Study &study)
{
  const double unit = spin_unit(study);
  if (study.load.source == LoadSource::file)
    return unit;
  try
  {
    const fem::Resultants load = study.required_resultants();
    const double share = std::abs(load.moment_x) / (load.normal_force * study.glass.profile.contact_radius);
    return share < 1e-12 ? unit : unit * std::clamp(2 * share, 1e-6, 1.);
  }
  catch (const BadInput &) // a model of the chain that tips
  {
    return unit;
  }
}

double rounding_of_spins(const Study &study)
{
  return 1e-9 * spin_scale(study);
}

double shown_spin(const Study &study, const ring::Answer &row, double fastest)
{
  if (std::abs(fastest) >= 0.01 * spin_unit(study))
    return fastest;
  const double torque = row.at_rest ? row.at_rest->friction.torque : 0;
  return std::copysign(0.1 * spin_unit(study), fastest != 0 ? fastest : torque);
}

std::string grip_holds_note(const Study &study, const ring::Answer &row)
{
  if (!row.terminal || !row.terminal->held || !row.at_rest)
    return "";
  const auto [torque, grip] =
    distinct_texts(std::abs(row.at_rest->friction.torque), study.motion.grip_torque);
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
                                  const Executor &executor, Progress &progress, const std::string &pieces)
{
  const auto row_of = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &its_foot)
  {
    if (variant.on_other_rings)
      its_foot->reset_rings();
    const SharedLoad load = load_of(variant, its_foot, asked);
    return LoadedRow{ variant, ring::answer(*load, spin_question(variant.study, asked)), load };
  };
  std::vector<LoadedRow> rows;
  for (const Solved<LoadedRow> &solved :
       solve(variants, foot, row_of, executor, counting_callback(progress, pieces, variants.size())))
  {
    const Variant &variant = variants[rows.size()];
    LoadedRow &added =
      rows.emplace_back(solved.answer ? *solved.answer : LoadedRow{ variant, failed_row(solved.failure) });
    if (variant.n_harmonics != all_harmonics)
      added.row.harmonics = variant.n_harmonics;
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

StudyRows rows_by_harmonics(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                            const ring::LoadAtSpin &load, ring::Question question, const Executor &executor,
                            Progress &progress, Depth depth, const std::vector<Variant> &others)
{
  const std::vector<unsigned int> orders = row_orders(study, load.n_harmonics(), depth);
  const ring::Motion &motion = question.motion;
  question.with_slope = true;
  const LoadedRow whole = { {}, ring::answer(load, question).value(), load.shared_from_this() };
  // Rows, curves and bands take about twice as long as the answer itself, the curves alone about as long.
  progress.share_done(depth == Depth::full ? 0.3 : 0.6);
  const std::optional<ring::TerminalSpin> &terminal = whole.row.terminal;
  question.with_slope = false;
  question.near = whole.row.zero_guess();
  if (whole.row.fall) // as far as the models with fewer harmonics, or without an effect, are known to stand
    question.initial_guess = whole.row.fall->omega;
  StudyRows rows;
  std::vector<LoadedRow> sharing;
  std::vector<Variant> variants;
  for (const unsigned int n : orders)
    if (n == orders.back())
      break;
    else if (study.load.is_in_balance() &&
             (load.phases() || !ring::are_negligible_above(n, whole.row, motion)))
      variants.push_back({ "harmonics", std::to_string(n), study, {}, {}, n, true });
    else
    {
      const ring::SharedLoad less = ring::truncated(whole.load, n);
      sharing.push_back({ {}, ring::answer(*less, question), less });
    }
  // Torques of rows that share the contacts of the whole load are asked for side by side, and that of the
  // whole is reported: half-way it is to be known.
  if (terminal && load.is_costly() && depth == Depth::full)
    ring::if_balanced([&] { return load.at(terminal->omega / 2); });
  std::copy_if(others.begin(), others.end(), std::back_inserter(variants),
               [](const Variant &other) { return !other.on_same_load; });
  std::vector<LoadedRow> solved;
  if (!variants.empty())
    solved = solve_rows(variants, foot, question, executor, progress, "models");
  auto next = solved.begin();
  for (; next != solved.end() && next->variant.key == "harmonics"; ++next)
    rows.by_harmonics.push_back(std::move(*next));
  for (const Variant &other : others)
    rows.others.push_back(
      other.on_same_load
        ? LoadedRow{ other, ring::answer(load, spin_question(other.study, question)), whole.load }
        : std::move(*next++));
  std::move(sharing.begin(), sharing.end(), std::back_inserter(rows.by_harmonics));
  rows.by_harmonics.push_back(whole);
  for (std::size_t i = 0; i < orders.size(); ++i)
  {
    ring::Answer &row = rows.by_harmonics[i].row;
    row.harmonics = orders[i];
    row = ring::compared_with_all(row, whole.row, load, motion);
  }
  return rows;
}

LoadedRow with_interpolated_load(LoadedRow row, double lower, double upper, const ring::LoadAtSpin *like)
{
  if (!row.load)
    return row;
  const auto between = [&](double one, double other, double enough = 2e-5)
  {
    return ring::if_balanced(
             [&] {
               return ring::interpolated(row.load, std::min(one, other), std::max(one, other), enough, like);
             })
      .value_or(nullptr);
  };
  ring::SharedLoad curve;
  if (const std::optional<ring::Fall> &fall = row.row.fall) // steep where the balance ends
    curve = between(0, fall->omega, 1e-3);
  else
  {
    const double terminal = row.row.omega_terminal().value_or(0), margin = 0.02 * std::abs(terminal);
    curve = between(lower, upper);
    if (!curve)
      curve = between(std::min(0., terminal - margin), std::max(0., terminal + margin));
  }
  if (curve)
    row.load = curve;
  return row;
}

} // namespace stemware::pipeline
