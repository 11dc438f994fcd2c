#include "fem/pipeline/analysis/comparison.h"

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "ring_model/unilateral_foundation.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

constexpr ring::Closure closures[] = { ring::Closure::paper, ring::Closure::hand, ring::Closure::full };

/// A load that a glass may stand on, under any moment balance, with any number of its harmonics.
struct ComparedLoad
{
  std::string name;
  std::vector<unsigned int> orders; ///< numbers of harmonics to keep, the last one is all
  /// Throws ring::Tipping for a moment balance under which the glass tips at rest, and as the contact.
  std::function<BalancedLoad(ring::Closure closure, unsigned int n_harmonics)> load;
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

ComparedLoad first_harmonic(const Study &study)
{
  return { compared_load::first_harmonic,
           { 1 },
           [&study](ring::Closure closure, unsigned int) { return first_harmonic_load(study, closure); },
           {} };
}

/// Share of the ring on which cos(theta - beta) > c.
double loaded_share(double edge)
{
  return edge <= -1 ? 1 : std::acos(edge) / boost::math::double_constants::pi;
}

/// A rigid ring of the contact radius on a foundation that only pushes, lambda ~ max(0, cos - c)^p.
ComparedLoad rigid_rim(const std::string &name, const Study &study, double exponent)
{
  const auto ring =
    std::make_shared<ring::UnilateralFoundation>(study.glass.profile.contact_radius, exponent);
  const auto n_all = static_cast<unsigned int>(ring->shape(1.5).size()) - 1;
  return { name, compared_orders(n_all),
           [&study, ring](ring::Closure closure, unsigned int n_harmonics)
           {
             const ring::Motion &motion = study.motion.orbit;
             const LoadReport at_rest =
               report_of(ring->rings(motion.normal_force(), ring::required_moment_at_rest(closure, motion)));
             return balance(ring, { motion, closure, {} }, at_rest, n_harmonics);
           },
           [ring](const BalancedLoad &load, double omega)
           { return loaded_share(ring->edge(load.at(omega).moment_ratio())); } };
}

/// The study with another moment balance; throws ring::Tipping where its foot tips at rest.
Study with_closure(Study study, ring::Closure closure)
{
  study.motion.closure = closure;
  try
  {
    study.required_resultants();
  }
  catch (const BadInput &failure)
  {
    throw ring::Tipping(failure.what());
  }
  return study;
}

/// The contact of the foot at rest under the study's moment balance.
LoadReport load_at_rest(const Study &study, const ElasticFoot &foot)
{
  const fem::Resultants demand = study.required_resultants();
  return report_of(foot.solve(demand.normal_force, { demand.moment_x, demand.moment_y }), foot.radius());
}

/// Harmonics of the loads of a foot, which are the same for all: those of its weight alone are counted.
unsigned int n_harmonics_of(const Study &study, const ElasticFoot &foot)
{
  return foot.rings(study.motion.orbit.normal_force(), Eigen::Vector2d::Zero()).n_harmonics();
}

/// The elastic foot with the load of rest at every spin: no friction acts back.
ComparedLoad foot_at_rest(const Study &study, const std::shared_ptr<ElasticFoot> &foot)
{
  return {
    compared_load::foot_at_rest, compared_orders(n_harmonics_of(study, *foot)),
    [&study, foot](ring::Closure closure, unsigned int n_harmonics) {
      return BalancedLoad({ load_at_rest(with_closure(study, closure), *foot), {} }).truncated(n_harmonics);
    },
    [](const BalancedLoad &load, double) { return load.report().contact_fraction; }
  };
}

/// The elastic foot in balance with friction at every spin.
ComparedLoad foot_in_balance(const Study &study, const std::shared_ptr<ElasticFoot> &foot)
{
  return { compared_load::foot_in_balance, compared_orders(n_harmonics_of(study, *foot)),
           [&study, foot](ring::Closure closure, unsigned int n_harmonics)
           {
             const Study own = with_closure(study, closure);
             return balance(foot, moment_balance(own), load_at_rest(own, *foot), n_harmonics);
           },
           [&study, foot](const BalancedLoad &load, double omega)
           {
             const ring::RingStack balanced = load.at(omega);
             return foot
               ->solve(balanced.normal_force(), balanced.moment(),
                       { omega / study.motion.orbit.orbit_speed, {} })
               .load.contact_fraction;
           } };
}

std::vector<ComparedLoad> compared_loads(const Study &study, const std::shared_ptr<ElasticFoot> &foot)
{
  std::vector<ComparedLoad> loads = { first_harmonic(study),
                                      rigid_rim(compared_load::rigid_flat_rim, study, 1.),
                                      rigid_rim(compared_load::rigid_round_rim, study, 1.5) };
  if (!foot)
    return loads;
  loads.push_back(foot_at_rest(study, foot));
  // Hundreds of contacts: for a foot that takes all ranks together only where the study asks for that.
  if (!foot->body().capabilities().is_collective || study.load.coupling == LoadCoupling::two_way)
    loads.push_back(foot_in_balance(study, foot));
  return loads;
}

/// What the load at the terminal spin is like.
Standing standing_of(const SpinRow &row)
{
  // A series that ends where the contact ends dips below 0 there by less than its last harmonics.
  const bool pulls = row.at_terminal->minimum < 0;
  if (!row.contact_fraction || (!row.all_harmonics && pulls))
    return pulls ? Standing::formal : Standing::full_contact;
  return *row.contact_fraction < 1 ? Standing::lift_off : Standing::full_contact;
}

SpinRow compared_row(const Study &study, const ComparedLoad &compared, ring::Closure closure, unsigned int n)
{
  SpinRow row;
  try
  {
    const BalancedLoad load = compared.load(closure, n);
    row = attempt_spin_row(load, { study.motion.orbit });
    row.all_harmonics = n == compared.orders.back();
    if (row.terminal && compared.contact_fraction)
      row.contact_fraction = compared.contact_fraction(load, row.terminal->omega);
    if (row.terminal)
      row.standing = standing_of(row);
  }
  catch (const std::exception &failure)
  {
    row.standing = standing_of_failure();
    row.reason = failure.what();
  }
  row.closure = closure;
  row.load = compared.name;
  row.harmonics = n;
  row.all_harmonics = n == compared.orders.back();
  return row;
}

/// Gives the foot in balance with all its harmonics its error bands under the moment balances that the answer
/// names.
void add_error_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot, std::vector<SpinRow> &rows)
{
  fem::ComplianceCache cache;
  for (SpinRow &row : rows)
  {
    if (row.load != compared_load::foot_in_balance || !row.all_harmonics || !row.terminal ||
        row.closure == ring::Closure::hand)
      continue;
    Study own = study;
    own.motion.closure = row.closure;
    own.load.coupling = LoadCoupling::two_way;
    if (has_quick_error_bands(own))
      row.band =
        band_of(estimate_bands(own, find_load(own, foot), row.terminal->omega, cache), "omega_terminal");
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

Comparison compare_models(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress)
{
  const std::vector<ComparedLoad> loads = compared_loads(study, foot);
  std::size_t n_all = 0;
  for (const ComparedLoad &load : loads)
    n_all += load.orders.size() * std::size(closures);

  Comparison comparison;
  for (const ring::Closure closure : closures)
    for (const ComparedLoad &load : loads)
      for (const unsigned int n : load.orders)
      {
        comparison.rows.push_back(compared_row(study, load, closure, n));
        progress.pieces_done("rows", comparison.rows.size(), n_all);
      }
  const std::optional<double> paper = comparison.rows.front().omega_terminal();
  for (SpinRow &row : comparison.rows)
    if (paper && *paper != 0 && row.terminal)
      row.difference_to_paper = row.terminal->omega / *paper - 1;
  progress.stage_done("comparison");
  add_error_bands(study, foot, comparison.rows);
  progress.stage_done("error_bands");
  return comparison;
}

} // namespace stemware::pipeline
