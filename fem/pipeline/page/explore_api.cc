#include "fem/pipeline/page/explore_api.h"

#include "fem/contact/footprint.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/page/explorer.h"
#include "fem/pipeline/result/curves.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"

#include <exception>
#include <optional>
#include <string>

namespace stemware::pipeline
{

namespace
{

Explorer explorer; // NOLINT: one explorer per page
std::string reply; // NOLINT: read by the page

Json ring_summary(const ring::Answer &row)
{
  Json ring = answer_fields().json(row);
  ring["message"] = row.reason;
  return ring;
}

const ring::RingState *end_of(const ring::Answer &row)
{
  return row.at_terminal ? &*row.at_terminal : row.fall ? &*row.fall : row.at_rest ? &*row.at_rest : nullptr;
}

Json document_of(const Results &results, const Json &summary = Json::object())
{
  return { { "summary", summary }, { "words", results.words }, { "tables", results.tables } };
}

/// Returns a part of the document of `stemware run`, with the same keys.
Json answer_document(const LiveAnswer &found)
{
  const Study &study = explorer.study();
  Results results;
  Json summary = { { "ring", ring_summary(found.full) },
                   { "paper", ring_summary(found.paper) },
                   { "first_n", found.truncated ? ring_summary(*found.truncated) : Json(nullptr) } };
  if (found.load_at_rest)
    summary["load"] = load_fields().json(*found.load_at_rest);
  if (const ring::RingState *end = end_of(found.full))
  {
    summary["load_at_terminal"] = load_fields().json(found.load);
    summary["load_at_terminal"]["tilt"] = { found.contact.solution.motion(1),
                                            found.contact.solution.motion(2) };
    if (const ring::RingState *first_n = found.truncated ? end_of(*found.truncated) : nullptr)
    {
      const auto [a, b] = series_of(first_n->load);
      summary["first_n"]["load"] = { { "a", a }, { "b", b } };
    }
    add_load_lines(found.load, results);
    add_motion(study.motion.orbit, study.glass.profile.contact_radius,
               { { { 0, found.full.last_spin().value_or(0), 0 }, *end } }, results);
    results.words["sketch"]["clockwise"] = study.motion.orbit.sense_sign() < 0;
    results.words["spin_unit"] = study.spin_unit();
    results.words["rounding"] = study.rounding_of_spins();
  }
  return document_of(results, summary);
}

/// Returns the JSON of @p make, or its failure with notes on implausible values, which are the likely cause.
template <typename Make>
const char *answer(const Make &make)
{
  try
  {
    reply = dump_utf8(make());
  }
  catch (const std::exception &failure)
  {
    reply = dump_utf8({ { "error", failure.what() },
                        { "tips", is_tipping(failure) },
                        { "notes", implausible_notes(entries_of(explorer.study())) } });
  }
  return reply.c_str();
}

} // namespace

} // namespace stemware::pipeline

using namespace stemware;
using namespace stemware::pipeline;

void explore_begin()
{
  explorer = Explorer();
}

void explore_take(const double *numbers, int is_disc)
{
  explorer.set_compliance(numbers, is_disc != 0);
}

const char *explore_set(const char *path, const char *value)
{
  return answer(
    [&]
    {
      explorer.set(path, value);
      return Json(Json::object());
    });
}

void explore_ready(double fineness)
{
  explorer.freeze_mesh(fineness);
}

const char *explore_solve(unsigned int n_harmonics, int cold)
{
  return answer(
    [&]
    {
      const LiveAnswer found = explorer.solve(n_harmonics == 0 ? all_harmonics : n_harmonics, cold != 0);
      return Json{ { "fit", found.mesh_differs ? "near" : "same" },
                   { "notes", implausible_notes(entries_of(explorer.study())) },
                   { "document", answer_document(found) } };
    });
}

const char *explore_pressure()
{
  return answer(
    [&]
    {
      Results results;
      if (const auto &contact = explorer.contact())
      {
        const fem::PressureMap map = explorer.pressure();
        results.tables["foot"] = {
          { "footprint", pressure_map(map, explorer.study().glass.profile.contact_radius,
                                      fem::largest_pressure(map), contact->load.peak_pressure) }
        };
      }
      return Json{ { "document", document_of(results) } };
    });
}

const char *explore_curves()
{
  return answer(
    [&]
    {
      Results results;
      if (const std::optional<StudyCurves> curves = explorer.curves())
      {
        Fields<std::size_t> torque = torque_columns(curves->torque);
        if (!curves->paper.empty())
          torque.add({ "tau_paper", "N m", "",
                       [&](std::size_t i) { return curves->paper[i].friction.torque; },
                       in_picture("paper") });
        add_curves(*curves, torque, spin_up_columns(curves->spin_up, curves->torque.n_first), results);
        add_motion(explorer.study().motion.orbit, explorer.study().glass.profile.contact_radius,
                   curves->spin_up.instants, results);
      }
      return Json{ { "document", document_of(results) } };
    });
}

const char *explore_budget()
{
  return answer(
    [&]
    {
      Results results;
      HarmonicEffect effect;
      if (const std::optional<StudyRows> models = explorer.models())
      {
        results.tables["waterfall"] = chain_fields().json(named_steps(assess_chain(*models)));
        effect = harmonic_effect(*models);
      }
      const Json summary = { { "harmonic_effect", harmonic_effect_fields().json(effect) } };
      return Json{ { "document", document_of(results, summary) } };
    });
}
