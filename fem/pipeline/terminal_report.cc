#include "fem/pipeline/terminal_report.h"

#include "fem/pipeline/console.h"
#include "fem/pipeline/contact_demand.h"
#include "fem/pipeline/text_layout.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

std::string harmonic_effect(const Study &study, const StudyResult &result)
{
  const std::vector<TruncationRow> &rows = result.yaw.truncations;
  const double omega = result.yaw.terminal.omega;
  if (study.load.source == LoadSource::first_harmonic)
    return formatted(
      "The first-harmonic load %s: torque at rest %.6g N m, terminal spin %.9g rad/s.",
      study.load.is_static()
        ? "of the given moment"
        : ("in balance with the closure " + ring::to_string(study.motion.closure) + " at every spin").c_str(),
      result.yaw.at_rest.torque, omega);
  const bool frozen = study.load.source != LoadSource::contact || study.load.coupling == LoadCoupling::frozen;
  std::string sentence = formatted(
    "Terminal spin %.6g rad/s under the load %s with its %u harmonics, %.6g rad/s with the first alone",
    omega, frozen ? "at rest" : "in balance at every spin", rows.back().harmonics,
    rows.front().omega_terminal);
  if (rows.front().relative_change)
    sentence += ": leaving out the others changes it by " + in_percent(rows.front().relative_change);
  return sentence + ".";
}

std::string closure_effect(const std::vector<ClosureRow> &rows)
{
  std::string sentence = "A first-harmonic load in balance at every spin would reach";
  bool any_formal = false;
  for (const ClosureRow &row : rows)
  {
    const std::string spin =
      row.omega_terminal ? formatted("%.6g rad/s", *row.omega_terminal) : "no terminal spin";
    sentence += (row.closure == rows.front().closure  ? " "
                 : row.closure == rows.back().closure ? " and "
                                                      : ", ") +
                spin + (row.is_formal() ? "*" : "") + " (" + ring::to_string(row.closure) + ")";
    any_formal = any_formal || row.is_formal();
  }
  return sentence + " with the three closures." +
         (any_formal ? " (* formal: such a load would have to pull on the table.)" : "");
}

std::string lift_off(const RingLoad &load)
{
  if (load.moment_ratio <= 1)
    return "";
  return formatted(" The moment ratio is %.4g, above 1: a first-harmonic load would have to pull; %.1f %% of "
                   "the rim carries load.",
                   load.moment_ratio, 100 * load.contact_fraction);
}

/// Says when the contact is narrower than what its nodes can show.
std::string narrow_contact(const Study &study, const std::optional<ContactFigures> &contact)
{
  if (!contact || contact->result.solution.outcome != fem::ContactOutcome::narrow_contact)
    return "";
  return formatted(
    " Contact is narrow, at most %u of its nodes side by side: %s.", contact->result.solution.n_nodes_across,
    study.table.kind == TableKind::rigid
      ? "on a rigid table the load then depends on the mesh; give more Radial cells on a narrower land"
      : "the table's pressure is integrated exactly, the foot's indentation just under it is not resolved");
}

std::string truncation_text(const std::vector<TruncationRow> &rows)
{
  TextColumn harmonics = { "harmonics", {} }, torque = { "torque at rest\n(N m)", {} },
             spin = { "terminal spin\n(rad/s)", {} }, change = { "change\nof spin", {} },
             bound = { "bound on torque\n(N m)", {} }, least = { "least load\n(N/rad)", {} };
  for (const TruncationRow &row : rows)
  {
    harmonics.cells.push_back(std::to_string(row.harmonics));
    torque.cells.push_back(formatted("%.7g", row.tau_at_rest));
    spin.cells.push_back(formatted("%.8g", row.omega_terminal));
    change.cells.push_back(in_percent(row.relative_change));
    bound.cells.push_back(formatted("%.3e", row.bound));
    least.cells.push_back(formatted("%.4g", row.load_minimum));
  }
  return text_table({ harmonics, torque, spin, change, bound, least });
}

} // namespace

void ProgressTable::add(const fem::ContactIteration &iteration)
{
  if (!has_header)
    console() << "  step   loaded  changed   imbalance   share taken   CG iterations\n";
  has_header = true;
  console() << formatted("  %4u %8u %8u   %9.2e   %11.3g   %13u", iteration.number, iteration.n_loaded,
                         iteration.n_changed, iteration.residual, iteration.step_fraction,
                         iteration.linear_iterations)
            << std::endl;
}

void print_load_source(const Study &study)
{
  if (study.load.source == LoadSource::file)
  {
    console() << "Load      " << study.load.file << std::endl;
    return;
  }
  const fem::ContactLoad demand = demanded_load(study);
  const double ratio = moment_ratio(demand, study.glass.profile.contact_radius);
  const double crest =
    std::atan2(demand.moment_x, -demand.moment_y) * 180 / boost::math::constants::pi<double>();
  const std::string origin =
    study.load.is_static() ? "given" : "closure " + ring::to_string(study.motion.closure) + " at rest";
  console() << formatted("Load      N = %.6g N, moment ratio %.6g (%s)", demand.normal_force, ratio,
                         origin.c_str());
  if (ratio > 0)
    console() << formatted(", largest at theta = %.4g deg", crest);
  console() << std::endl;
}

void print_mesh(const FootContact &contact)
{
  console() << "Foot      " << contact.name() << ", ";
  if (contact.n_cells())
    console() << formatted("%u cells, ", *contact.n_cells());
  console() << formatted("%u unknowns, %u contact nodes", contact.n_unknowns(), contact.n_contact_nodes())
            << std::endl;
  if (contact.mesh_report() && !contact.mesh_report()->round_rim)
    console() << formatted("          straight edges: the land's area is %.2g %% too small",
                           100 * contact.mesh_report()->land_area_deficit)
              << std::endl;
}

void print_balance(std::size_t n_states)
{
  if (n_states % 500 == 0)
    console() << "  contact and friction in balance at " << n_states << " spins" << std::endl;
}

void print_answer(const Study &study, const StudyResult &result)
{
  console() << '\n'
            << wrapped(harmonic_effect(study, result) + lift_off(result.load) +
                       narrow_contact(study, result.contact))
            << '\n'
            << wrapped(closure_effect(result.closures)) << "\n\n"
            << truncation_text(result.yaw.truncations) << std::endl;
}

} // namespace stemware::pipeline
