#include "fem/pipeline/analysis/comparison.h"

#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/coupling/if_balanced.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/variants/model_variants.h"
#include "ring_model/unilateral_foundation.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace stemware::pipeline
{

namespace
{

constexpr ring::Closure closures[] = { ring::Closure::paper, ring::Closure::hand, ring::Closure::full };

/// A load that a glass may stand on: that of a study's foot, or of a rim.
struct ComparedLoad
{
  std::string name;
  Study study;
  std::shared_ptr<ElasticFoot> foot = nullptr;
  std::shared_ptr<const ring::UnilateralFoundation> rim = nullptr;
};

/// A rigid ring of the contact radius on a foundation that only pushes, lambda ~ max(0, cos - c)^p.
ComparedLoad rigid_rim(const std::string &name, const Study &study, double exponent)
{
  return { name, first_harmonic_study(study), nullptr,
           std::make_shared<ring::UnilateralFoundation>(study.glass.profile.contact_radius, exponent) };
}

Study with_coupling(Study study, LoadCoupling coupling)
{
  study.load.coupling = coupling;
  return study;
}

Study with_closure(Study study, ring::Closure closure)
{
  study.motion.closure = closure;
  return study;
}

/// A foot in contact with the table, on the rings that its loads under all moment balances have in common:
/// those of the first one that has a load.
ComparedLoad foot_load(const std::string &name, const Study &study, const std::shared_ptr<ElasticFoot> &foot)
{
  for (const ring::Closure closure : closures)
    if (!foot->has_rings())
      if_balanced(
        [&]
        {
          require_standing(with_closure(study, closure));
          return find_load(with_closure(study, closure), foot);
        });
  return { name, study, foot };
}

std::vector<ComparedLoad> compared_loads(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const Executor &executor)
{
  std::vector<ComparedLoad> loads = { { compared_load::first_harmonic, first_harmonic_study(study) },
                                      rigid_rim(compared_load::rigid_flat_rim, study, 1.),
                                      rigid_rim(compared_load::rigid_round_rim, study, 1.5) };
  if (!foot)
    return loads;
  const BodyAbilities can = abilities(study.contact.body);
  Study rigid = with_coupling(study, LoadCoupling::two_way);
  rigid.model.foot_is_rigid = true;
  if (can.is_of_revolution && has_compliance(rigid))
    try
    {
      loads.push_back(foot_load(compared_load::rigid_foot, rigid, study_foot(rigid, executor.make_foot)));
    }
    catch (const BadInput &) // a foot that cannot be made: each row says so
    {
      loads.push_back({ compared_load::rigid_foot, rigid });
    }
  loads.push_back(foot_load(compared_load::foot_at_rest, with_coupling(study, LoadCoupling::one_way), foot));
  // Hundreds of contacts: for a foot that takes all ranks together only where the study asks for that.
  if (!can.is_collective || study.load.coupling == LoadCoupling::two_way)
    loads.push_back(
      foot_load(compared_load::foot_in_balance, with_coupling(study, LoadCoupling::two_way), foot));
  return loads;
}

/// Share of the rim that carries @p load in balance at a spin; nothing for a formal load.
std::optional<double> contact_fraction(const ComparedLoad &compared, const BalancedLoad &load, double omega)
{
  if (!compared.rim)
  {
    const std::optional<fem::ContactState> state = load.contact(omega);
    return state ? std::optional(state->load.contact_fraction) : std::nullopt;
  }
  // Share of the ring on which cos(theta - beta) > c.
  const double edge = compared.rim->edge(load.at(omega).moment_ratio(compared.rim->radius()));
  return edge <= -1 ? 1 : std::acos(edge) / boost::math::double_constants::pi;
}

/// Standing of the row's load at its terminal spin, which it must have.
Standing standing_of(const SpinRow &row)
{
  // A series that ends where the contact ends dips below 0 there by less than its last harmonics.
  const bool pulls = row.at_terminal->minimum < 0;
  if (!row.contact_fraction || (!row.all_harmonics && pulls))
    return pulls ? Standing::formal : Standing::full_contact;
  return *row.contact_fraction < 1 ? Standing::lift_off : Standing::full_contact;
}

/// The rows of a load under each moment balance, with 1, 2, 3 and all harmonics, where these are more.
std::vector<SpinRow> compared_rows(const ComparedLoad &compared, const Executor &executor)
{
  std::vector<Variant> variants;
  for (const ring::Closure closure : closures)
    for (const unsigned int n : { 1u, 2u, 3u, all_harmonics })
      variants.push_back({ "", compared.name, with_closure(compared.study, closure), n,
                           compared.foot != nullptr, "", compared.rim });
  std::vector<SpinRow> rows;
  unsigned int n_all = 1;
  for (const LoadedRow &solved : solve_rows(variants, compared.foot, {}, executor))
  {
    const Variant &variant = variants[rows.size()];
    SpinRow &row = rows.emplace_back(solved.row);
    row.load = compared.name;
    row.all_harmonics = variant.n_harmonics == all_harmonics;
    if (row.terminal)
    {
      row.contact_fraction = contact_fraction(compared, *solved.load, row.terminal->omega);
      row.standing = standing_of(row);
    }
    if (row.reason.empty())
      row.reason = held_by_the_grip(variant.study, row);
    if (row.all_harmonics)
      n_all = std::max(n_all, row.harmonics);
  }
  for (SpinRow &row : rows)
    row.harmonics = row.all_harmonics ? n_all : row.harmonics;
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [=](const SpinRow &row) { return !row.all_harmonics && row.harmonics >= n_all; }),
             rows.end());
  return rows;
}

/// Gives the elastic foot two-way with all its harmonics its error bands under the moment balances that the
/// answer names.
void add_error_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                     std::vector<SpinRow> &rows)
{
  for (SpinRow &row : rows)
  {
    if (row.load != compared_load::foot_in_balance || !row.all_harmonics || !row.terminal ||
        row.closure == ring::Closure::hand)
      continue;
    const Study own = with_closure(with_coupling(study, LoadCoupling::two_way), row.closure);
    row.band = band_of(estimate_bands(own, foot, row, std::nullopt, executor), "omega_terminal");
  }
}

} // namespace

const SpinRow *Comparison::find(ring::Closure closure, const std::string &load, unsigned int n) const
{
  for (const SpinRow &row : rows)
    if (row.closure == closure && row.load == load && (n == 0 ? row.all_harmonics : row.harmonics == n))
      return &row;
  return nullptr;
}

HarmonicEffect Comparison::harmonic_effect(ring::Closure closure, const std::string &load) const
{
  const SpinRow *first = find(closure, load, 1), *all = find(closure, load);
  return first && all ? pipeline::harmonic_effect(first->omega_terminal(), all->omega_terminal(), spin_scale)
                      : HarmonicEffect();
}

Comparison compare_models(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          const Executor &executor, Progress &progress)
{
  const std::vector<ComparedLoad> loads = compared_loads(study, foot, executor);
  Comparison comparison;
  comparison.spin_scale = spin_scale(study);
  std::vector<SpinRow> &rows = comparison.rows;
  std::size_t n_done = 0;
  for (const ComparedLoad &load : loads)
  {
    const std::vector<SpinRow> of_load = compared_rows(load, executor);
    rows.insert(rows.end(), of_load.begin(), of_load.end());
    progress.pieces_done("loads", ++n_done, loads.size());
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const SpinRow &one, const SpinRow &other) { return one.closure < other.closure; });
  const std::optional<double> paper = rows.front().omega_terminal();
  for (SpinRow &row : rows)
    if (paper && row.terminal)
      row.difference_to_paper = relative_to(paper, row.terminal->omega - *paper, comparison.spin_scale);
  progress.stage_done("comparison");
  add_error_bands(study, foot, executor, rows);
  const std::string &own_load = loads.back().name;
  std::vector<SpinRow> own;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
               [&](const SpinRow &row)
               { return row.closure == study.motion.closure && row.load == own_load; });
  const bool in_balance = own_load == compared_load::foot_in_balance;
  comparison.budget =
    budget_rows(in_balance ? with_coupling(study, LoadCoupling::two_way) : study, foot, own, executor);
  add_bands(own.back().band, std::nullopt, comparison.budget);
  progress.stage_done("error_bands");
  return comparison;
}

} // namespace stemware::pipeline
