#include "fem/pipeline/variants/answer_share.h"

#include "fem/pipeline/coupling/study_balance.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

/// Contacts of a variant, and costs of contacts over a contact of the study that starts from a near one;
/// rough means of random studies.
struct WorkNumbers
{
  double first = 12;             ///< cost of the first contact, if others follow at other spins
  double hard_over_phases = 4.4; ///< mean cost of the study's contacts over phases and spins of a hard table
  double search = 6;             ///< contacts of a search for a terminal spin from that of a similar study
  double over_phases = 30;       ///< contacts of a row over phases, beside the samples of the study
  double curves = 14;            ///< contacts of the curves over the spin
  double hard = 8;               ///< cost of a contact under a hard table instead of a compliant one
  double hard_phases = 600;      ///< cost of the phases under a hard table beside a compliant one
  double spins = 6, spins_with_lift_off = 10; ///< spins at which bands are evaluated
  double phases = 4;                          ///< phases at which bands are evaluated
  double spins_of_change = 2;                 ///< beside rest, on a changed foot over phases
  /// Costs of a contact at rest at another phase, that of a compliant table and of a hard one.
  double rest = 2, hard_rest = 12;
  /// Costs of the changes of a band: cells, degree and harmonics; four and three times the lines; a harder
  /// spring; a mesh file with all cells halved, by multigrid, over multigrid and over a condensed foot.
  double cells = 3, lines = 5.5, spring = 1.5, halved_file = 10, halved_over_condensed = 200;
};
constexpr WorkNumbers numbers = {};

double cost_of_row(const Study &study, const AnswerWork &answer, const Variant &variant)
{
  if (!variant.reason.empty() || !variant.study.load.is_from_contact())
    return 0;
  if (variant.on_same_load) // at another spin
    return answer.depends_on_phase ? static_cast<double>(answer.n_contacts) : 0;
  const bool is_level = study.has_waviness() && !variant.study.has_waviness();
  const bool is_harder = variant.study.table.is_hard() && !study.table.is_hard();
  if (answer.depends_on_phase && !is_level)
    return is_harder ? numbers.hard_phases
                     : std::min(static_cast<double>(answer.n_contacts), numbers.over_phases);
  return (varies_with_spin(variant.study) ? numbers.search : 1) * (is_harder ? numbers.hard : 1);
}

/// Cost of the changes of a band, over one contact at each of their phases and spins.
double cost_of_changes(const Study &study, const AnswerWork &answer)
{
  const bool is_hard = study.table.is_hard();
  if (abilities(study.contact.body).is_of_revolution)
    return numbers.cells + (answer.lifts_off ? numbers.lines : 0) + (is_hard ? numbers.spring : 0);
  if (study.contact.mesh_file.empty() || study.contact.refinements > 0)
    return 0;
  return (is_hard ? 2 : 1) * (study.contact.linear_solver == fem::LinearSolver::automatic
                                ? numbers.halved_over_condensed
                                : numbers.halved_file);
}

double cost_of_bands(const Study &study, const AnswerWork &answer)
{
  const bool follows = varies_with_spin(study);
  const double phases = answer.depends_on_phase ? numbers.phases : 1;
  const double spins = !follows ? 1 : answer.lifts_off ? numbers.spins_with_lift_off : numbers.spins;
  const double changes = cost_of_changes(study, answer), own = spins * phases;
  if (!abilities(study.contact.body).is_of_revolution)
    return own + changes * (phases + (follows ? numbers.spins_of_change : 0));
  if (!answer.depends_on_phase || !follows)
    return own + changes * own;
  const double rest = study.table.is_hard() ? numbers.hard_rest : numbers.rest;
  return own + changes * phases * (rest + numbers.spins_of_change);
}

} // namespace

WorkShares work_shares(const Study &study, const AnswerWork &answer, const std::vector<Variant> &variants,
                       bool with_bands)
{
  const double first = varies_with_spin(study) ? numbers.first : 1;
  const bool is_cold = answer.depends_on_phase && study.table.is_hard() && varies_with_spin(study);
  const double own = first + (is_cold ? numbers.hard_over_phases : 1) *
                               (static_cast<double>(std::max<std::size_t>(answer.n_contacts, 1)) - 1);
  double with_variants = own, left = 0;
  for (const Variant &variant : variants)
    with_variants += cost_of_row(study, answer, variant);
  if (varies_with_spin(study) && !answer.depends_on_phase)
    left += numbers.curves;
  if (with_bands && study.load.is_from_contact())
    left += cost_of_bands(study, answer);
  const double all = with_variants + left;
  return { own / all, with_variants / all };
}

} // namespace stemware::pipeline
