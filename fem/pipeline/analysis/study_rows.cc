#include "fem/pipeline/analysis/study_rows.h"

#include "fem/pipeline/coupling/if_balanced.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/friction_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// Relates @p row to the row of all harmonics: change of the terminal spin, and the a-priori bound with the
/// pressure @p whole behind the row at the terminal spin of all harmonics.
void relate_to_all(const SpinRow &all, const ring::RingStack &whole, const SpinQuestion &question,
                   SpinRow &row)
{
  const ring::Motion &motion = question.motion;
  const double omega = all.terminal->omega;
  // Without a moment the glass does not spin up; rounding makes that a tiny spin, to which nothing can be
  // related.
  const double scale = motion.orbit_speed / all.at_rest->load.radius();
  if (row.terminal && std::abs(omega) > 1e-9 * scale)
    row.relative_change = (row.terminal->omega - omega) / omega + 0.; // no -0
  row.bound = ring::truncation_bound(motion, whole, row.harmonics, omega);
}

/// Bound and least load of the worst phase instead of those of the mean load. @p whole has all harmonics.
void take_worst_phase(const BalancedLoad &whole, const ring::Motion &motion, double omega, SpinRow &row)
{
  for (const ring::RingStack &load : whole.phases()->samples(omega))
    row.bound = std::max(*row.bound, ring::truncation_bound(motion, load, row.harmonics, omega));
  for (const ring::RingStack &load : whole.phases()->samples(0))
    row.at_rest->minimum = std::min(row.at_rest->minimum, load.truncated(row.harmonics).minimum());
}

/// Whether the harmonics of the load above @p n move neither torque nor balance at the terminal spin of @p
/// whole: by a tenth of what the search for it leaves, as the bound of their torque tells.
bool are_negligible_above(unsigned int n, const SpinRow &whole, const ring::Motion &motion)
{
  constexpr double negligible = 1e-12; // of the terminal spin
  const std::optional<ring::KnownZero> zero = known_zero(whole);
  return zero && ring::truncation_bound(motion, whole.at_terminal->load, n, zero->omega) <
                   negligible * std::abs(zero->slope * zero->omega);
}

/// The load of @p variant on its @p foot, whose terminal spin is believed to be where @p asked has it.
SharedLoad load_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                   const SpinQuestion &asked)
{
  const std::optional<double> expected = asked.near            ? std::optional(asked.near->omega)
                                         : asked.expected != 0 ? std::optional(asked.expected)
                                                               : std::nullopt;
  return find_load(variant.study, foot, silent_progress(), variant.n_harmonics, expected);
}

/// The load of @p answer interpolated in the spin from @p lower to @p upper, or to where its glass falls
/// over; where there is no balance all the way, from rest to its terminal spin; exact where that fails too.
/// @p like is BalancedLoad::interpolated()'s.
SharedLoad interpolated(const LoadedRow &answer, double lower, double upper,
                        const BalancedLoad *like = nullptr)
{
  const auto between = [&](double one, double other, double enough = 2e-5)
  {
    return if_balanced(
             [&]
             { return answer.load->interpolated(std::min(one, other), std::max(one, other), enough, like); })
      .value_or(nullptr);
  };
  SharedLoad curve;
  if (const std::optional<Fall> &fall = answer.row.fall) // steep where the balance ends
    curve = between(0, fall->omega, 1e-3);
  else
  {
    const double terminal = answer.row.omega_terminal().value_or(0), margin = 0.02 * std::abs(terminal);
    curve = between(lower, upper);
    if (!curve)
      curve = between(std::min(0., terminal - margin), std::max(0., terminal + margin));
  }
  return curve ? curve : answer.load;
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

double shown_spin(const Study &study, const SpinRow &row, double fastest)
{
  if (std::abs(fastest) >= 0.01 * spin_unit(study))
    return fastest;
  const double torque = row.at_rest ? row.at_rest->friction.torque : 0;
  return std::copysign(0.1 * spin_unit(study), fastest != 0 ? fastest : torque);
}

std::string held_by_the_grip(const Study &study, const SpinRow &row)
{
  if (!row.terminal || !row.terminal->held || !row.at_rest)
    return "";
  const auto [torque, grip] = told_apart(std::abs(row.at_rest->friction.torque), study.motion.grip_torque);
  return "The fingers hold the glass at rest: the torque there, " + torque +
         " N m, is no more than Motion/Grip torque = " + grip + " N m.";
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

SpinQuestion spin_question(const Study &study, SpinQuestion question)
{
  question.motion = study.motion.orbit;
  question.grip_torque = study.motion.grip_torque;
  if (study.load.source != LoadSource::file)
    question.contact_radius = study.glass.profile.contact_radius;
  return question;
}

std::vector<LoadedRow> solve_rows(const std::vector<Variant> &variants,
                                  const std::shared_ptr<ElasticFoot> &foot, const SpinQuestion &asked,
                                  const Executor &executor, Progress &progress, const std::string &pieces)
{
  const auto row_of = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &its_foot)
  {
    if (variant.on_other_rings)
      its_foot->forget_rings();
    const SharedLoad load = load_of(variant, its_foot, asked);
    return LoadedRow{ attempt_spin_row(*load, spin_question(variant.study, asked)), load };
  };
  std::vector<LoadedRow> rows;
  for (const Solved<LoadedRow> &solved :
       solve(variants, foot, row_of, executor, counted(progress, pieces, variants.size())))
  {
    const Variant &variant = variants[rows.size()];
    LoadedRow &added =
      rows.emplace_back(solved.answer ? *solved.answer : LoadedRow{ failed_row(solved.failure) });
    if (variant.n_harmonics != all_harmonics)
      added.row.harmonics = variant.n_harmonics;
  }
  return rows;
}

std::optional<ring::KnownZero> known_zero(const SpinRow &row)
{
  if (!row.terminal || row.terminal->held || !(row.terminal->torque_slope < 0) || row.terminal->omega == 0)
    return std::nullopt;
  return ring::KnownZero{ row.terminal->omega, row.terminal->torque_slope };
}

std::vector<LoadedRow> rows_by_harmonics(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const BalancedLoad &load, SpinQuestion question,
                                         const Executor &executor, Progress &progress, Depth depth,
                                         RowsBeside *beside)
{
  const std::vector<unsigned int> orders = row_orders(study, load.n_harmonics(), depth);
  question.with_slope = true;
  const LoadedRow whole = { spin_row(load, question), load.shared_from_this() };
  question.with_slope = false;
  question.near = known_zero(whole.row);
  if (whole.row.fall) // as far as the models with fewer harmonics, or without an effect, are known to stand
    question.expected = whole.row.fall->omega;
  std::vector<LoadedRow> rows, sharing;
  std::vector<Variant> cut;
  for (std::size_t i = 0; i + 1 < orders.size(); ++i)
    if (study.load.is_in_balance() &&
        (load.phases() || !are_negligible_above(orders[i], whole.row, question.motion)))
      cut.push_back({ "harmonics", std::to_string(orders[i]), study, orders[i], true });
    else if (const SharedLoad less = load.truncated(orders[i]))
      sharing.push_back({ attempt_spin_row(*less, question), less });
  // Torques of rows that share the contacts of the whole load are asked for side by side, and that of the
  // whole is reported: half-way it is to be known.
  if (whole.row.terminal && load.is_costly() && depth == Depth::full)
    if_balanced([&] { return load.at(whole.row.terminal->omega / 2); });
  const std::size_t n_cut = cut.size();
  if (beside)
    for (const Variant &variant : beside->variants(whole.row))
      cut.push_back(variant);
  if (!cut.empty())
    rows = solve_rows(cut, foot, question, executor, progress, "models");
  if (beside)
    beside->answers.assign(rows.begin() + static_cast<std::ptrdiff_t>(n_cut), rows.end());
  rows.resize(n_cut);
  rows.insert(rows.end(), sharing.begin(), sharing.end());
  rows.push_back(whole);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    SpinRow &row = rows[i].row;
    row.harmonics = orders[i];
    if (whole.row.terminal)
      relate_to_all(whole.row, whole.row.at_terminal->load, question, row);
    if (whole.row.terminal && load.phases() && row.at_rest)
      take_worst_phase(load, question.motion, whole.row.terminal->omega, row);
  }
  return rows;
}

void interpolate_loads(double lower, double upper, unsigned int n_most, const Executor &executor,
                       std::vector<LoadedRow> &rows)
{
  LoadedRow &all = rows.back();
  if (all.load)
    all.load = interpolated(all, lower, upper);
  const auto interpolate = [&](std::size_t i)
  {
    if (rows[i].load && rows[i].row.harmonics <= n_most)
      rows[i].load = interpolated(rows[i], lower, upper, all.load.get());
  };
  executor.for_each(rows.size() - 1, interpolate);
}

} // namespace stemware::pipeline
