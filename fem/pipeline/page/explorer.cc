#include "fem/pipeline/page/explorer.h"

#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/revolution/revolution_foot.h"
#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Maximum factor, in either direction, between the half-width of a focused contact and the half-width for
/// which the mesh was made (docs/explore.md).
constexpr double farthest = 1.5;

/// Returns true if an entry can change without new compliances. Compliances scale with the moduli and do not
/// depend on the motion.
bool is_live(const std::string &path)
{
  static const std::vector<std::string> outside_motion = {
    "Glass/Contact radius",     "Glass/Crown radius",
    "Glass/Young modulus",      "Table/Foundation modulus",
    "Table/Disc Young modulus", "Table/Reference pressure",
    "Table/Decay length",       "Contact/Rings",
    "Contact/Azimuth lines",    "Contact/Load harmonics",
    "Contact/Friction coupling"
  };
  if (path == "Motion/Orbit speed file")
    return false;
  return path.rfind("Motion/", 0) == 0 || path == "Load/Coupling" || path == "Load/Moment ratio" ||
         path == "Load/Moment direction" ||
         std::find(outside_motion.begin(), outside_motion.end(), path) != outside_motion.end();
}

struct BalanceNearby
{
  ring::TerminalSpin spin;
  fem::ContactState contact;
  ring::Sample load;
};

/// Returns the terminal spin near @p near for @p n_harmonics harmonics, accurate to 1e-8 rad/s, with its
/// contact and load. Two or three contact solves start from @p contact. Returns std::nullopt if the search
/// fails, if the load does not vary with the spin, or if @p foot has one ring or does not fit @p contact.
std::optional<BalanceNearby> balance_near(const ring::TerminalSpin &near, const fem::ContactState &contact,
                                          const std::shared_ptr<ElasticFoot> &foot, unsigned int n_harmonics)
{
  const auto &[study, discretisation, model] = foot->specification();
  if (!study.varies_with_spin() || foot->ring_radii().empty() || contact.zone != 0 ||
      contact.solution.forces.size() != foot->body().description().n_contact_nodes)
    return std::nullopt;
  const ring::Motion &motion = study.motion.orbit;
  BalancedContact contacts(foot, moment_balance(study, n_harmonics), contact);
  std::optional<BalanceNearby> last;
  const auto torque = [&](double omega)
  {
    fem::ContactState state = contacts.contact(omega);
    ring::Sample load = contacts.sample_of(state);
    last = BalanceNearby{ near, std::move(state), std::move(load) };
    return ring::wrench(motion, last->load, omega).torque + last->load.lean_torque();
  };
  ring::SpinSearch search{ motion.orbit_speed / foot->radius() };
  search.grip_torque = study.motion.grip_torque;
  search.tolerance = 1e-8 / std::max(std::abs(near.omega), 1e-3 * search.spin_scale);
  const std::optional<ring::TerminalSpin> zero = ring::find_terminal_spin_near(near, torque, search);
  if (!zero || zero->omega * near.omega <= 0)
    return std::nullopt;
  last->spin = *zero;
  return last;
}

/// Inverse of serialized().
fem::ContactCompliance deserialized(const double *numbers)
{
  fem::ContactCompliance compliance;
  const auto n = static_cast<Eigen::Index>(numbers[0]);
  compliance.degree = static_cast<unsigned int>(numbers[1]);
  compliance.harmonics.resize(static_cast<std::size_t>(numbers[2]) + 1);
  compliance.n_meridian_unknowns = static_cast<unsigned int>(numbers[3]);
  compliance.n_inside = static_cast<Eigen::Index>(numbers[4]);
  compliance.n_outside = static_cast<Eigen::Index>(numbers[5]);
  numbers += 6;
  compliance.radii = Eigen::Map<const Eigen::VectorXd>(numbers, n);
  numbers += n;
  const auto read_harmonic = [&](fem::HarmonicCompliance &harmonic)
  {
    harmonic.normal.resize(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = j; i < n; ++i)
        harmonic.normal(i, j) = harmonic.normal(j, i) = *numbers++;
    for (Eigen::MatrixXd *matrix : { &harmonic.radial, &harmonic.azimuthal })
    {
      *matrix = Eigen::Map<const Eigen::MatrixXd>(numbers, n, n);
      numbers += n * n;
    }
  };
  for (fem::HarmonicCompliance &harmonic : compliance.harmonics)
    read_harmonic(harmonic);
  read_harmonic(compliance.tail);
  return compliance;
}

} // namespace

void Explorer::set_compliance(const double *numbers, bool is_disc)
{
  (is_disc ? disc_compliance : compliance) = deserialized(numbers);
}

void Explorer::set(const std::string &entry_path, const std::string &value)
{
  const std::vector<StudyEntry> entries = study_entries(present);
  const StudyEntry &entry = entry_at(entries, "", entry_path);
  ensure(!is_ready || is_live(entry_path) || entry.text() == value,
         entry_path + " needs another mesh than this page has; use `stemware run`.");
  assign(entry, "", value);
  if (!is_ready || entry_path != "Glass/Contact radius")
    return;
  Study smaller = base;
  const std::vector<StudyEntry> of_base = study_entries(smaller);
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i].section == "Glass" && entries[i].unit == "m" && entries[i].quantity &&
        entries[i].name != "Crown radius" && entries[i].path() != entry_path)
      *entries[i].quantity = size() * *of_base[i].quantity;
}

void Explorer::freeze_mesh(double fineness)
{
  discretisation.fineness = fineness;
  base = present;
  is_ready = true;
}

bool Explorer::mesh_differs() const
{
  const fem::MeridianResolution now = revolution_setup({ present, discretisation }).resolution;
  const fem::MeridianResolution then = revolution_setup({ base, discretisation }).resolution;
  const auto differ = [](double one, double other) { return std::abs(one - other) > 1e-9 * std::abs(other); };
  const double ratio = now.has_focus() && then.has_focus() ? now.focus_size / (size() * then.focus_size) : 1;
  ensure(now.refinements == then.refinements && !differ(now.land_grading, then.land_grading) &&
           !differ(now.focus_radius, size() * then.focus_radius) && now.has_focus() == then.has_focus() &&
           std::max(ratio, 1 / ratio) <= farthest,
         "The mesh of this page does not resolve the width of this contact; use `stemware run`.");
  return differ(ratio, 1);
}

std::shared_ptr<fem::Foot> Explorer::make_foot(const FootSpecification &specification) const
{
  const auto of = [](const fem::ContactCompliance &given, double modulus, double modulus_now)
  { return modulus == modulus_now ? given : given.scaled(modulus / modulus_now); };
  const fem::RevolutionSetup setup = revolution_setup(specification);
  const fem::ContactCompliance own =
    of(compliance, base.glass.material.young_modulus, specification.study.glass.material.young_modulus);
  std::optional<fem::ContactCompliance> below;
  if (setup.table.substrate)
    below = of(disc_compliance, base.table.disc_material.young_modulus,
               specification.study.table.disc_material.young_modulus);
  return std::make_shared<fem::RevolutionFoot>(
    setup, std::make_shared<const fem::ContactCompliance>(
             setup.total_compliance(own, below ? &*below : nullptr).similar(size())));
}

Executor Explorer::executor() const
{
  return Executor([this](const FootSpecification &specification, const fem::Foot *)
                  { return make_foot(specification); });
}

LiveAnswer Explorer::solve(unsigned int n_harmonics, bool cold)
{
  const std::shared_ptr<ElasticFoot> last = std::exchange(foot, nullptr);
  rows.clear();
  present.check_values();
  present.required_resultants(); // throws if the glass tips at rest
  LiveAnswer answer;
  answer.mesh_differs = mesh_differs();
  const bool from_last = !cold && last && last->has_rings();
  if (!from_last || !follow(*last, n_harmonics, answer))
    solve_cold(from_last ? last.get() : nullptr, n_harmonics, answer);
  contact_at_zero = answer.contact;
  answer.load = report_of(answer.contact, foot->radius(), present.tilts());
  paper.variant.study = paper_study(present);
  paper.load = find_load(paper.variant.study, nullptr);
  paper.row = answer.paper = ring::answer(*paper.load, spin_question(paper.variant.study));
  if (answer.truncated)
    shift_of_truncated = answer.truncated->last_spin().value_or(0) - answer.full.last_spin().value_or(0);
  return answer;
}

bool Explorer::follow(const ElasticFoot &last, unsigned int n_harmonics, LiveAnswer &answer)
{
  if (!zero || !contact_at_zero)
    return false;
  foot = study_foot({ present, discretisation }, executor().make_foot);
  foot->set_rings(last.ring_radii(), last.n_harmonics());
  const auto row_of = [&](const BalanceNearby &found)
  {
    const double omega = found.spin.omega;
    ring::Answer row;
    row.harmonics = found.load.n_harmonics();
    row.terminal = found.spin;
    row.at_terminal = ring::ring_state(found.load, spin_question(present), omega);
    row.status = ring::Status::full_contact;
    return row;
  };
  try
  {
    const auto all = balance_near(*zero, *contact_at_zero, foot, all_harmonics);
    if (!all)
      return false;
    if (n_harmonics < foot->n_harmonics())
    {
      const ring::TerminalSpin beside = { all->spin.omega + shift_of_truncated, all->spin.torque_slope };
      const auto cut = balance_near(beside, all->contact, foot, n_harmonics);
      if (!cut)
        return false;
      answer.truncated = row_of(*cut);
    }
    answer.full = row_of(*all);
    answer.contact = all->contact;
    zero = all->spin;
    return true;
  }
  catch (const ring::NoBalance &)
  {
    return false;
  }
}

void Explorer::solve_cold(const ElasticFoot *last, unsigned int n_harmonics, LiveAnswer &answer)
{
  foot = study_foot({ present, discretisation }, executor().make_foot, silent_progress(), last);
  if (last)
    foot->set_rings(last->ring_radii(), last->n_harmonics());
  ring::Question question = spin_question(present);
  question.with_slope = !last; // computing the slope takes too long while a slider is moved
  if (last)
    question.zero_guess = zero;
  const BalancedLoad load = find_load(present, foot);
  answer.full = ring::answer(load, question);
  zero = answer.full.zero_guess();
  if (!zero && question.zero_guess && answer.full.omega_terminal())
    zero = ring::TerminalSpin{ *answer.full.omega_terminal(), question.zero_guess->torque_slope };
  if (n_harmonics < foot->n_harmonics())
  {
    question.zero_guess = zero;
    const BalancedLoad cut = find_load(present, foot, silent_progress(), n_harmonics);
    answer.truncated = ring::answer(cut, question);
    answer.truncated->harmonics = n_harmonics;
    rows.push_back({ { foot->specification() }, *answer.truncated, cut });
  }
  rows.push_back({ { foot->specification() }, answer.full, load });
  answer.contact = load.contact(answer.full.last_spin().value_or(0)).value();
  if (answer.full.at_rest)
    answer.load_at_rest = load.report();
}

std::optional<StudyCurves> Explorer::curves()
{
  if (rows.empty() || !rows.back().row.last_spin())
    return std::nullopt;
  return find_curves(rows, paper, curve_load(rows), ring::output_times(present.motion.end_time), executor());
}

std::optional<StudyRows> Explorer::models()
{
  if (rows.empty())
    return std::nullopt;
  const Executor solver = executor();
  return rows_by_harmonics({ foot->specification().study, foot, solver }, *rows.back().load, Depth::rows,
                           model_chain({ foot->specification() }));
}

std::vector<double> serialized(const fem::ContactCompliance &compliance)
{
  std::vector<double> numbers = {
    static_cast<double>(compliance.n_nodes()),     static_cast<double>(compliance.degree),
    static_cast<double>(compliance.n_harmonics()), static_cast<double>(compliance.n_meridian_unknowns),
    static_cast<double>(compliance.n_inside),      static_cast<double>(compliance.n_outside)
  };
  const auto add = [&](const auto &values) { numbers.insert(numbers.end(), values.begin(), values.end()); };
  add(compliance.radii);
  const auto add_harmonic = [&](const fem::HarmonicCompliance &harmonic)
  {
    for (Eigen::Index j = 0; j < harmonic.normal.cols(); ++j)
      add(harmonic.normal.col(j).tail(harmonic.normal.rows() - j));
    add(harmonic.radial.reshaped());
    add(harmonic.azimuthal.reshaped());
  };
  for (const fem::HarmonicCompliance &harmonic : compliance.harmonics)
    add_harmonic(harmonic);
  add_harmonic(compliance.tail);
  return numbers;
}

} // namespace stemware::pipeline
