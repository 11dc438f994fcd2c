#include "fem/pipeline/variants/answer_share.h"

#include "fem/pipeline/coupling/study_balance.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

/// Contacts of a variant, and costs of contacts over those of the study's own; rough means of random studies.
struct WorkNumbers
{
  double search = 6;  ///< contacts of a search for a terminal spin from that of a similar study
  double curves = 14; ///< contacts of the curves over the spin
  double hard = 8;    ///< cost of a contact under a hard table instead of a compliant one
  double spins = 6, spins_with_lift_off = 10; ///< spins at which bands are evaluated
  double phases = 4;                          ///< phases at which bands are evaluated
  /// Costs of the changes of a band: cells, degree and harmonics; four and three times the lines; a harder
  /// spring; a mesh file with all cells halved, by multigrid, over multigrid and over a condensed foot.
  double cells = 1.2, lines = 7, spring = 1.5, halved_file = 10, halved_over_condensed = 200;
};
constexpr WorkNumbers numbers = {};

double contacts_of(const Study &study, const AnswerWork &answer, const Variant &variant)
{
  if (variant.on_same_load || !variant.reason.empty() || !variant.study.load.is_from_contact())
    return 0;
  const bool is_level = study.has_waviness() && !variant.study.has_waviness();
  if (answer.depends_on_phase && !is_level)
    return static_cast<double>(answer.n_contacts);
  return varies_with_spin(variant.study) ? numbers.search : 1;
}

double contacts_of_bands(const Study &study, const AnswerWork &answer)
{
  const bool is_of_revolution = abilities(study.contact.body).is_of_revolution;
  double cost = 1;
  if (is_of_revolution)
    cost +=
      numbers.cells + (answer.lifts_off ? numbers.lines : 0) + (study.table.is_hard() ? numbers.spring : 0);
  else if (!study.contact.mesh_file.empty() && study.contact.refinements == 0)
    cost += (study.table.is_hard() ? 2 : 1) * (study.contact.linear_solver == fem::LinearSolver::automatic
                                                 ? numbers.halved_over_condensed
                                                 : numbers.halved_file);
  const double spins = !varies_with_spin(study) ? 1
                       : answer.lifts_off       ? numbers.spins_with_lift_off
                                                : numbers.spins;
  return cost * spins * (answer.depends_on_phase ? numbers.phases : 1);
}

} // namespace

double share_of_answer(const Study &study, const AnswerWork &answer, const std::vector<Variant> &variants,
                       bool with_bands)
{
  const auto own = static_cast<double>(std::max<std::size_t>(answer.n_contacts, 1));
  double all = own;
  if (varies_with_spin(study) && !answer.depends_on_phase)
    all += numbers.curves;
  for (const Variant &variant : variants)
    all += contacts_of(study, answer, variant) *
           (variant.study.table.is_hard() && !study.table.is_hard() ? numbers.hard : 1);
  if (with_bands && study.load.is_from_contact())
    all += contacts_of_bands(study, answer);
  return own / all;
}

} // namespace stemware::pipeline
