#include "fem/pipeline/terminal_report.h"

#include "fem/pipeline/contact_demand.h"
#include "fem/pipeline/ranks.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// printf into a string: columns and digits at a glance.
template <typename... Values>
std::string formatted(const char *format, Values... values)
{
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)) + 1, ' ');
  std::snprintf(text.data(), text.size(), format, values...);
  text.pop_back();
  return text;
}

std::string in_percent(const std::optional<double> &share)
{
  return share ? formatted("%+.3g %%", 100 * *share) : "-";
}

/// Breaks a text between words into lines of at most 96 columns.
std::string wrapped(const std::string &text)
{
  constexpr std::size_t width = 96;
  std::istringstream words(text);
  std::string lines;
  std::size_t column = 0;
  for (std::string word; words >> word; column += word.size() + 1)
  {
    if (column > 0 && column + word.size() > width)
    {
      lines += '\n';
      column = 0;
    }
    else if (column > 0)
      lines += ' ';
    lines += word;
  }
  return lines;
}

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

} // namespace

std::ostream &console()
{
  static std::ostream stream(is_first_rank() ? std::cout.rdbuf() : nullptr);
  return stream;
}

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

void print_demand(const Study &study, const fem::ContactLoad &demand)
{
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
  console()
    << '\n'
    << wrapped(harmonic_effect(study, result) + lift_off(result.load) + narrow_contact(study, result.contact))
    << '\n'
    << wrapped(closure_effect(result.closures)) << "\n\n"
    << "  harmonics   torque at rest   terminal spin        change   bound on torque    least load\n"
    << "                       (N m)         (rad/s)        of spin             (N m)       (N/rad)\n";
  for (const TruncationRow &row : result.yaw.truncations)
    console() << formatted("  %9u   %14.7g   %13.8g   %11s   %15.3e   %11.4g\n", row.harmonics,
                           row.tau_at_rest, row.omega_terminal, in_percent(row.relative_change).c_str(),
                           row.bound, row.load_minimum);
  console() << std::endl;
}

} // namespace stemware::pipeline
