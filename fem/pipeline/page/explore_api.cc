#include "fem/pipeline/page/explore_api.h"

#include "fem/contact/contact_solution.h"
#include "fem/contact/footprint.h"
#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/page/explorer.h"
#include "fem/pipeline/result/pictures.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "ring_model/failures.h"

#include <exception>
#include <memory>
#include <string>

namespace stemware::pipeline
{

namespace
{

std::unique_ptr<Explorer> explorer = std::make_unique<Explorer>(); // NOLINT: one explorer per page
std::optional<fem::ContactState> last_contact;                     // NOLINT
std::string reply;                                                 // NOLINT: read by the page

Json ring_summary(const ring::Answer &row)
{
  Json ring = answer_fields().json(row);
  ring["message"] = row.reason;
  return ring;
}

Json series_summary(const ring::RingStack &load)
{
  const auto [a, b] = series_of(load);
  return { { "a", a }, { "b", b } };
}

Json load_summary(const ring::RingState &state, double contact_radius)
{
  const Eigen::Vector2d moment = state.load.moment();
  Json load = series_summary(state.load);
  load.update({ { "ring_radius", state.load.radius() },
                { "normal_force", state.load.normal_force() },
                { "moment", { moment.x(), moment.y() } },
                { "moment_ratio", state.load.moment_ratio(contact_radius) },
                { "minimum", finite_or_null(state.minimum) } });
  return load;
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
  const Study &study = explorer->study();
  Results results;
  Json summary = { { "ring", ring_summary(found.full) },
                   { "paper", ring_summary(found.paper) },
                   { "first_n", found.truncated ? ring_summary(*found.truncated) : Json(nullptr) } };
  if (found.full.at_rest)
    summary["load"] = load_summary(*found.full.at_rest, found.contact_radius);
  if (const ring::RingState *end = end_of(found.full))
  {
    Json &load = summary["load_at_terminal"] = load_summary(*end, found.contact_radius);
    LoadReport report;
    report.rings = end->load;
    if (found.contact)
    {
      report.contact_fraction = found.contact->load.contact_fraction;
      report.pointwise = found.contact->load.pointwise;
      load["contact_fraction"] = report.contact_fraction;
      load["tilt"] = { found.contact->solution.motion(1), found.contact->solution.motion(2) };
    }
    if (const ring::RingState *first_n = found.truncated ? end_of(*found.truncated) : nullptr)
      summary["first_n"]["load"] = series_summary(first_n->load);
    add_load_lines(report, results);
    add_motion(study, { { { 0, found.full.last_spin().value_or(0), 0 }, *end } }, results);
    results.words["sketch"]["clockwise"] = study.motion.orbit.sense_sign() < 0;
    results.words["spin_unit"] = study.spin_unit();
    results.words["rounding"] = study.rounding_of_spins();
  }
  return document_of(results, summary);
}

/// Returns a failure as JSON, with notes on implausible values, which are its likely cause.
Json failure_of(const std::string &message, bool tips)
{
  return { { "error", message }, { "tips", tips }, { "notes", implausible_notes(explorer->study()) } };
}

template <typename Make>
const char *answer(const Make &make)
{
  try
  {
    reply = dump_utf8(make());
  }
  catch (const ring::Tipping &failure)
  {
    reply = dump_utf8(failure_of(failure.what(), true));
  }
  catch (const fem::ContactFailure &failure)
  {
    reply = dump_utf8(failure_of(failure.what(), failure.outcome == fem::ContactOutcome::tipping));
  }
  catch (const std::exception &failure)
  {
    reply = dump_utf8(failure_of(failure.what(), false));
  }
  return reply.c_str();
}

const char *name_of(MeshMatch match)
{
  return match == MeshMatch::same ? "same" : match == MeshMatch::close ? "near" : "foreign";
}

} // namespace

} // namespace stemware::pipeline

using namespace stemware;
using namespace stemware::pipeline;

void explore_begin()
{
  explorer = std::make_unique<Explorer>();
}

void explore_take(const double *numbers, int is_disc)
{
  explorer->set_compliance(std::make_shared<const fem::ContactCompliance>(deserialized(numbers)),
                           is_disc != 0);
}

const char *explore_set(const char *path, const char *value)
{
  return answer(
    [&]
    {
      explorer->set(path, value);
      return Json(Json::object());
    });
}

void explore_ready(double fineness)
{
  explorer->freeze_mesh(fineness);
}

const char *explore_solve(unsigned int n_harmonics, int cold)
{
  return answer(
    [&]
    {
      const LiveAnswer found = explorer->solve(n_harmonics == 0 ? all_harmonics : n_harmonics, cold != 0);
      last_contact = found.contact;
      return Json{ { "fit", name_of(found.match) },
                   { "notes", implausible_notes(explorer->study()) },
                   { "document", answer_document(found) } };
    });
}

const char *explore_pressure()
{
  return answer(
    [&]
    {
      Results results;
      if (last_contact)
      {
        const fem::PressureMap map = explorer->pressure(*last_contact);
        results.tables["foot"] = {
          { "footprint", pressure_map(map, explorer->study().glass.profile.contact_radius,
                                      fem::largest_pressure(map), last_contact->load.peak_pressure) }
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
      if (const std::optional<StudyCurves> curves = explorer->curves())
      {
        add_torque_columns(curves->torque, friction_torques(curves->paper), results);
        add_spin_up_columns(curves->spin_up, curves->n_first, results);
        add_motion(explorer->study(), curves->spin_up.instants, results);
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
      const Budget budget = explorer->budget();
      results.tables["waterfall"] = chain_fields().json(named_steps(budget.rows));
      return Json{ { "document", document_of(results, { { "harmonic_effect", harmonic_effect_fields().json(
                                                                               budget.harmonics) } }) } };
    });
}
