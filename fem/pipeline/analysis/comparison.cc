#include "fem/pipeline/analysis/comparison.h"

#include "fem/pipeline/analysis/model_variants.h"
#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/unilateral_foundation.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

constexpr ring::Closure closures[] = { ring::Closure::paper, ring::Closure::hand, ring::Closure::full };

/// A load that a glass may stand on.
struct ComparedLoad
{
  std::string name;
  /// The load of a study with its harmonics up to n. Throws what contacts and balances throw.
  std::function<SharedLoad(const Study &study, unsigned int n_harmonics)> find;
  /// Share of the rim that carries load in balance at a spin; empty for a formal load.
  std::function<double(const BalancedLoad &load, double omega)> contact_fraction;
};

/// Truncations that are compared: 1, 2, 3 and all.
std::vector<unsigned int> compared_orders(unsigned int n_all)
{
  std::vector<unsigned int> orders;
  for (const unsigned int n : { 1u, 2u, 3u })
    if (n < n_all)
      orders.push_back(n);
  orders.push_back(n_all);
  return orders;
}

ComparedLoad first_harmonic()
{
  return { compared_load::first_harmonic,
           [](const Study &study, unsigned int) { return find_load(first_harmonic_study(study), nullptr); },
           {} };
}

/// Share of the ring on which cos(theta - beta) > c.
double loaded_share(double edge)
{
  return edge <= -1 ? 1 : std::acos(edge) / boost::math::double_constants::pi;
}

/// A rigid ring of the contact radius on a foundation that only pushes, lambda ~ max(0, cos - c)^p.
ComparedLoad rigid_rim(const std::string &name, double contact_radius, double exponent)
{
  const auto ring = std::make_shared<ring::UnilateralFoundation>(contact_radius, exponent);
  return { name,
           [ring](const Study &study, unsigned int n_harmonics)
           {
             const ring::Motion &motion = study.motion.orbit;
             const ring::Closure closure = study.motion.closure;
             const LoadReport at_rest =
               report_of(ring->rings(motion.normal_force(), ring::required_moment_at_rest(closure, motion)));
             return balance(ring, motion, closure, at_rest, n_harmonics);
           },
           [ring](const BalancedLoad &load, double omega)
           { return loaded_share(ring->edge(load.at(omega).moment_ratio(ring->radius()))); } };
}

/// A foot in contact with the table, as in the variant of a study.
ComparedLoad foot_load(const std::string &name, const std::function<std::shared_ptr<ElasticFoot>()> &foot,
                       const std::function<Study(Study)> &variant)
{
  return { name,
           [=](const Study &study, unsigned int n_harmonics)
           {
             require_standing(study);
             return find_load(variant(study), foot(), silent_progress(), n_harmonics);
           },
           [](const BalancedLoad &load, double omega)
           { return load.contact(omega)->load.contact_fraction; } };
}

Study with_coupling(Study study, LoadCoupling coupling)
{
  study.load.coupling = coupling;
  return study;
}

Study with_rigid_foot(Study study)
{
  study.model.foot_is_rigid = true;
  return with_coupling(study, LoadCoupling::two_way);
}

std::vector<ComparedLoad> compared_loads(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         fem::ComplianceCache &cache)
{
  const double radius = study.glass.profile.contact_radius;
  std::vector<ComparedLoad> loads = { first_harmonic(), rigid_rim(compared_load::rigid_flat_rim, radius, 1.),
                                      rigid_rim(compared_load::rigid_round_rim, radius, 1.5) };
  if (!foot)
    return loads;
  const BodyAbilities can = abilities(study.contact.body);
  if (can.is_of_revolution && has_compliance(with_rigid_foot(study)))
  {
    // Made by the first row that asks: where it cannot be made, the rows say so.
    const auto made = std::make_shared<std::shared_ptr<ElasticFoot>>();
    const auto rigid_foot = [&cache, made, rigid = with_rigid_foot(study)]
    { return *made ? *made : *made = study_foot(rigid, cache); };
    loads.push_back(foot_load(compared_load::rigid_foot, rigid_foot, with_rigid_foot));
  }
  const auto own_foot = [foot] { return foot; };
  loads.push_back(foot_load(compared_load::foot_at_rest, own_foot,
                            [](const Study &own) { return with_coupling(own, LoadCoupling::one_way); }));
  // Hundreds of contacts: for a foot that takes all ranks together only where the study asks for that.
  if (!can.is_collective || study.load.coupling == LoadCoupling::two_way)
    loads.push_back(foot_load(compared_load::foot_in_balance, own_foot,
                              [](const Study &own) { return with_coupling(own, LoadCoupling::two_way); }));
  return loads;
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

/// Row of a load under the moment balance of @p study, whose reason is filled in where something is missing.
SpinRow compared_row(const Study &study, const ComparedLoad &compared, unsigned int n, bool is_all)
{
  SpinRow row;
  try
  {
    const SharedLoad load = compared.find(study, n);
    row = attempt_spin_row(*load, spin_question(study));
    row.all_harmonics = is_all;
    if (row.terminal && compared.contact_fraction)
      row.contact_fraction = compared.contact_fraction(*load, row.terminal->omega);
    if (row.terminal)
      row.standing = standing_of(row);
    if (row.reason.empty())
      row.reason = held_by_the_grip(study, row);
  }
  catch (...)
  {
    note_failure(row);
  }
  row.closure = study.motion.closure;
  row.load = compared.name;
  if (!is_all)
    row.harmonics = n;
  row.all_harmonics = is_all;
  return row;
}

Study with_closure(Study study, ring::Closure closure)
{
  study.motion.closure = closure;
  return study;
}

/// Rows of a load, [moment balance][truncation]: under each of them as many, the one of all harmonics being
/// the last.
std::vector<std::vector<SpinRow>> compared_rows(const Study &study, const ComparedLoad &compared)
{
  std::vector<SpinRow> all;
  unsigned int n_all = 1;
  for (const ring::Closure closure : closures)
  {
    all.push_back(compared_row(with_closure(study, closure), compared, all_harmonics, true));
    n_all = std::max(n_all, all.back().harmonics);
  }
  std::vector<std::vector<SpinRow>> rows;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    rows.emplace_back();
    for (const unsigned int n : compared_orders(n_all))
      if (n < n_all)
        rows.back().push_back(compared_row(with_closure(study, closures[i]), compared, n, false));
    rows.back().push_back(all[i]);
    rows.back().back().harmonics = n_all;
  }
  return rows;
}

/// Gives the elastic foot two-way with all its harmonics its error bands under the moment balances that the
/// answer names.
void add_error_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                     fem::ComplianceCache &cache, std::vector<SpinRow> &rows)
{
  for (SpinRow &row : rows)
  {
    if (row.load != compared_load::foot_in_balance || !row.all_harmonics || !row.terminal ||
        row.closure == ring::Closure::hand)
      continue;
    Study own = study;
    own.motion.closure = row.closure;
    own.load.coupling = LoadCoupling::two_way;
    row.band = band_of(estimate_bands(own, foot, row, std::nullopt, cache), "omega_terminal");
  }
}

/// The study's way from the paper's model to the load of @p own, its rows by harmonics.
std::vector<BudgetRow> budget_of(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                 const std::vector<SpinRow> &own)
{
  return budget_rows(
    own.front().load == compared_load::foot_in_balance ? with_coupling(study, LoadCoupling::two_way) : study,
    foot, own);
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
                          fem::ComplianceCache &cache, Progress &progress)
{
  const std::vector<ComparedLoad> loads = compared_loads(study, foot, cache);
  Comparison comparison;
  comparison.spin_scale = spin_scale(study);
  std::vector<std::vector<std::vector<SpinRow>>> rows;
  for (const ComparedLoad &load : loads)
  {
    rows.push_back(compared_rows(study, load));
    progress.pieces_done("loads", rows.size(), loads.size());
  }
  for (std::size_t i = 0; i < std::size(closures); ++i)
    for (const auto &of_load : rows)
      comparison.rows.insert(comparison.rows.end(), of_load[i].begin(), of_load[i].end());
  const std::optional<double> paper = comparison.rows.front().omega_terminal();
  for (SpinRow &row : comparison.rows)
    if (paper && row.terminal)
      row.difference_to_paper = relative_to(paper, row.terminal->omega - *paper, comparison.spin_scale);
  progress.stage_done("comparison");
  add_error_bands(study, foot, cache, comparison.rows);
  for (const auto &of_closure : rows.back())
    if (of_closure.front().closure == study.motion.closure)
      comparison.budget = budget_of(study, foot, of_closure);
  if (const SpinRow *own = comparison.find(study.motion.closure, comparison.rows.back().load))
    add_bands(own->band, std::nullopt, comparison.budget);
  progress.stage_done("error_bands");
  return comparison;
}

} // namespace stemware::pipeline
