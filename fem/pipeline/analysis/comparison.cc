#include "fem/pipeline/analysis/comparison.h"

#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/coupling/if_balanced.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/variants/model_variants.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// The study's glass on a load, whose friction acts with all its harmonics.
Variant on_load(const std::string &name, const Study &study, bool on_same_foot = false)
{
  return { "", name, study, all_harmonics, on_same_foot };
}

/// On a rigid ring of the contact radius on a foundation that only pushes, lambda ~ max(0, cos - c)^p.
Variant on_rigid_rim(const std::string &name, const Study &study, double exponent)
{
  Variant variant = on_load(name, first_harmonic_study(study));
  variant.rigid_ring =
    std::make_shared<ring::UnilateralFoundation>(study.glass.profile.contact_radius, exponent);
  return variant;
}

Study with_coupling(Study study, LoadCoupling coupling)
{
  study.load.coupling = coupling;
  return study;
}

/// The loads that a glass may stand on under any moment balance: those of rims, and of the study's foot.
std::vector<Variant> compared_loads(const Study &study)
{
  std::vector<Variant> loads = { on_load(compared_load::first_harmonic, first_harmonic_study(study)),
                                 on_rigid_rim(compared_load::rigid_flat_rim, study, 1.),
                                 on_rigid_rim(compared_load::rigid_round_rim, study, 1.5) };
  if (!study.load.is_from_contact())
    return loads;
  const BodyAbilities can = abilities(study.contact.body);
  const Study two_way = with_coupling(study, LoadCoupling::two_way);
  Study rigid = two_way;
  rigid.model.foot_is_rigid = true;
  if (can.is_of_revolution && has_compliance(rigid))
    loads.push_back(on_load(compared_load::rigid_foot, rigid));
  loads.push_back(on_load(compared_load::foot_at_rest, with_coupling(study, LoadCoupling::one_way), true));
  // Hundreds of contacts: for a foot that takes all ranks together only where the study asks for that.
  if (!can.is_collective || study.load.coupling == LoadCoupling::two_way)
    loads.push_back(on_load(compared_load::foot_in_balance, two_way, true));
  return loads;
}

/// Places the rings that loads on the study's foot have in common: those of the first variant that has one.
void place_rings(const std::vector<Variant> &variants, const std::shared_ptr<ElasticFoot> &foot)
{
  for (const Variant &variant : variants)
    if (variant.on_same_foot && !foot->has_rings())
      if_balanced(
        [&]
        {
          require_standing(variant.study);
          return find_load(variant.study, foot);
        });
}

/// Share of the rim that carries @p load in balance at a spin; nothing for a formal load.
std::optional<double> contact_fraction(const Variant &variant, const BalancedLoad &load, double omega)
{
  if (!variant.rigid_ring)
  {
    const std::optional<fem::ContactState> state = load.contact(omega);
    return state ? std::optional(state->load.contact_fraction) : std::nullopt;
  }
  // Share of the ring on which cos(theta - beta) > c.
  const ring::UnilateralFoundation &rim = *variant.rigid_ring;
  const double edge = rim.edge(load.at(omega).moment_ratio(rim.radius()));
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

std::vector<Variant> compared_models(const Study &study)
{
  std::vector<Variant> variants;
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
    for (const Variant &load : compared_loads(study))
      for (const unsigned int n : { 1u, 2u, 3u, all_harmonics })
      {
        Variant &variant = variants.emplace_back(load);
        variant.study.motion.closure = closure;
        variant.n_harmonics = n;
      }
  return variants;
}

Comparison compare_variants(const Study &study, const std::vector<Variant> &variants,
                            const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                            Progress &progress)
{
  place_rings(variants, foot);
  Comparison comparison;
  comparison.spin_scale = spin_scale(study);
  std::vector<SpinRow> &rows = comparison.rows;
  std::map<std::string, unsigned int> n_all; // harmonics of each load
  for (const LoadedRow &solved : solve_rows(variants, foot, {}, executor, progress, "models"))
  {
    const Variant &variant = variants[rows.size()];
    SpinRow &row = rows.emplace_back(solved.row);
    row.load = variant.name;
    row.all_harmonics = variant.n_harmonics == all_harmonics;
    if (row.terminal)
    {
      row.contact_fraction = contact_fraction(variant, *solved.load, row.terminal->omega);
      row.standing = standing_of(row);
    }
    if (row.reason.empty())
      row.reason = held_by_the_grip(variant.study, row);
    if (row.all_harmonics)
      n_all[row.load] = std::max(n_all[row.load], row.harmonics);
  }
  for (SpinRow &row : rows)
    if (row.all_harmonics)
      row.harmonics = n_all[row.load];
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [&](const SpinRow &row)
                            { return !row.all_harmonics && row.harmonics >= n_all[row.load]; }),
             rows.end());
  progress.stage_done("comparison");
  return comparison;
}

void judge_models(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                  Comparison &comparison)
{
  const std::optional<double> paper = comparison.rows.front().omega_terminal();
  const std::string own_load = comparison.rows.back().load;
  const bool in_balance = own_load == compared_load::foot_in_balance;
  Study own = in_balance ? with_coupling(study, LoadCoupling::two_way) : study;
  std::vector<SpinRow> of_study;
  for (SpinRow &row : comparison.rows)
  {
    if (paper && row.terminal)
      row.difference_to_paper = relative_to(paper, row.terminal->omega - *paper, comparison.spin_scale);
    // Bands of what the answer names.
    if (in_balance && row.load == own_load && row.all_harmonics && row.terminal &&
        row.closure != ring::Closure::hand)
    {
      own.motion.closure = row.closure;
      row.band = band_of(estimate_bands(own, foot, row, std::nullopt, executor), "omega_terminal");
    }
    if (row.load == own_load && row.closure == study.motion.closure)
      of_study.push_back(row);
  }
  own.motion.closure = study.motion.closure;
  comparison.budget = budget_rows(own, foot, of_study, executor);
  add_bands(of_study.back().band, std::nullopt, comparison.budget);
}

} // namespace stemware::pipeline
