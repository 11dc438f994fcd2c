#include "fem/pipeline/explore/explore_api.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/explore/explorer.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/no_balance.h"

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

std::unique_ptr<Explorer> explorer = std::make_unique<Explorer>(); // NOLINT: a page has one
std::optional<fem::ContactState> last_contact;                     // NOLINT
std::string reply;                                                 // NOLINT: what the page reads

/// A value as JSON.
struct Json
{
  Json(double value)
      : text("null")
  {
    if (!std::isfinite(value))
      return;
    // Not the shortest text: where the standard library does not have it, that takes seventeen trials.
    std::array<char, 32> digits;
    std::snprintf(digits.data(), digits.size(), "%.17g", value);
    text = digits.data();
  }
  Json(bool value)
      : text(value ? "true" : "false")
  {
  }
  Json(unsigned int value)
      : text(std::to_string(value))
  {
  }
  Json(const std::string &value)
      : text("\"")
  {
    for (const char letter : value)
      if (letter == '"' || letter == '\\')
        text += std::string("\\") + letter;
      else
        text += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    text += '"';
  }
  Json(const char *value)
      : Json(std::string(value))
  {
  }
  Json(const Eigen::Vector2d &vector)
      : Json(std::vector<double>(vector.begin(), vector.end()))
  {
  }
  template <typename Value>
  Json(const std::optional<Value> &value)
      : text(value ? Json(*value).text : "null")
  {
  }
  template <typename Value>
  Json(const std::vector<Value> &values)
      : text("[")
  {
    for (const Value &value : values)
      text += (text == "[" ? "" : ",") + Json(value).text;
    text += ']';
  }
  /// An object.
  using Members = std::initializer_list<std::pair<const char *, Json>>;
  Json(Members members)
      : text("{}")
  {
    for (const auto &[key, value] : members)
      add(key, value);
  }

  /// Adds a member to an object.
  void add(const std::string &key, const Json &value)
  {
    text.pop_back();
    text += (text == "{" ? "" : ",") + Json(key).text + ':' + value.text + '}';
  }

  std::string text;
};

/// State of the rim: its load by harmonics, friction and torques.
Json state_json(const ring::RingState &state, double contact_radius)
{
  const ring::RingStack &load = state.load;
  std::vector<double> a, b;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    a.push_back(load.a(n));
    b.push_back(load.b(n));
  }
  return Json{ { "a", a },
               { "b", b },
               { "normal_force", load.normal_force() },
               { "moment", load.moment() },
               { "moment_ratio", load.moment_ratio(contact_radius) },
               { "friction", std::vector<double>{ state.friction.force_x, state.friction.force_y } },
               { "torque", state.friction.torque },
               { "lean_torque", state.lean_torque },
               { "grip_torque", state.grip_torque },
               { "minimum", state.minimum },
               { "pulling_share", state.pulling_share } };
}

Json row_json(const ring::Answer &row, double contact_radius)
{
  Json object = { { "omega", row.omega_terminal() }, { "last_spin", row.last_spin() },
                  { "falls", row.fall.has_value() }, { "time_constant", row.time_constant() },
                  { "harmonics", row.harmonics },    { "standing", to_string(row.status) },
                  { "reason", row.reason } };
  if (row.at_rest)
    object.add("at_rest", state_json(*row.at_rest, contact_radius));
  if (row.at_terminal)
    object.add("at_end", state_json(*row.at_terminal, contact_radius));
  else if (row.fall)
    object.add("at_end", state_json(row.fall->state, contact_radius));
  return object;
}

Json contact_json(const fem::ContactState &contact)
{
  std::vector<double> azimuths, loads;
  for (const fem::AzimuthLoad &place : contact.load.pointwise)
  {
    azimuths.push_back(place.azimuth);
    loads.push_back(place.density);
  }
  return Json{ { "azimuth", azimuths },
               { "load", loads },
               { "inner_radius", contact.inner_radius },
               { "outer_radius", contact.outer_radius },
               { "motion",
                 std::vector<double>(contact.solution.motion.begin(), contact.solution.motion.end()) },
               { "contact_fraction", contact.load.contact_fraction } };
}

/// Answers with what @p make returns, or with why it throws.
template <typename Make>
const char *answer(const Make &make)
{
  try
  {
    reply = make().text;
  }
  catch (const ring::Tipping &failure)
  {
    const std::string sentence = with_implausible_values(explorer->study(), failure.what());
    reply = Json{ { "error", sentence }, { "tips", true } }.text;
  }
  catch (const fem::ContactFailure &failure)
  {
    const bool tips = failure.outcome == fem::ContactOutcome::tipping;
    reply = Json{ { "error", failure.what() }, { "tips", tips } }.text;
  }
  catch (const std::exception &failure)
  {
    reply = Json{ { "error", failure.what() }, { "tips", false } }.text;
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
  explorer->take(std::make_shared<const fem::ContactCompliance>(deserialized(numbers)), is_disc != 0);
}

const char *explore_set(const char *path, const char *value)
{
  return answer(
    [&]
    {
      explorer->set(path, value);
      return Json(Json::Members{});
    });
}

void explore_ready(double fineness)
{
  explorer->ready(fineness);
}

const char *explore_entries()
{
  return answer(
    [&]
    {
      Study copy = explorer->study();
      std::vector<Json> entries;
      for (const StudyEntry &entry : study_entries(copy))
        entries.push_back(Json{ { "path", entry.path() },
                                { "unit", entry.unit },
                                { "allowed", entry.allowed },
                                { "help", entry.help },
                                { "value", entry.text() },
                                { "acts", entry.has_effect } });
      return Json(entries);
    });
}

const char *explore_solve(unsigned int n_harmonics, int cold)
{
  return answer(
    [&]
    {
      const LiveAnswer found = explorer->solve(n_harmonics == 0 ? all_harmonics : n_harmonics, cold != 0);
      last_contact = found.contact;
      Json object = { { "fit", name_of(found.match) },
                      { "contact_radius", found.contact_radius },
                      { "all", row_json(found.all, found.contact_radius) },
                      { "paper", row_json(found.paper, found.contact_radius) },
                      { "notes", implausible_notes(explorer->study()) } };
      if (found.first_n)
        object.add("first_n", row_json(*found.first_n, found.contact_radius));
      if (found.contact)
        object.add("contact", contact_json(*found.contact));
      return object;
    });
}

const char *explore_pressure(unsigned int n_azimuths)
{
  return answer(
    [&]
    {
      if (!last_contact)
        return Json(Json::Members{});
      const fem::PressureMap map = explorer->pressure(*last_contact);
      const std::size_t step = std::max<std::size_t>(1, map.cuts.size() / std::max(1u, n_azimuths));
      std::vector<double> azimuths;
      std::vector<Json> cuts;
      for (std::size_t i = 0; i < map.cuts.size(); i += step)
      {
        if (map.cuts[i].empty())
          continue;
        std::string radii, pressures;
        for (const fem::PressurePoint &point : map.cuts[i])
        {
          radii += (radii.empty() ? "[" : ",") + to_short_text(point.radius);
          pressures += (pressures.empty() ? "[" : ",") + to_short_text(point.pressure);
        }
        azimuths.push_back(map.cuts[i].front().azimuth);
        cuts.emplace_back("");
        cuts.back().text = "[" + radii + "]," + pressures + "]]";
      }
      return Json{ { "azimuth", azimuths }, { "cuts", cuts } };
    });
}

const char *explore_curves()
{
  return answer(
    [&]
    {
      const std::optional<LiveCurves> curves = explorer->curves();
      if (!curves)
        return Json(Json::Members{});
      const TorqueCurve &torque = curves->torque;
      std::vector<double> of_all;
      for (const ring::Wrench &friction : torque.friction)
        of_all.push_back(friction.torque);
      Json object = { { "spin", torque.omega },      { "torque", of_all },
                      { "sum", torque.sum },         { "of_paper", curves->of_paper },
                      { "time", curves->time },      { "omega", curves->spin },
                      { "omega_n", curves->spin_n }, { "omega_paper", curves->spin_paper } };
      if (!torque.truncations.empty())
        object.add("of_n", torque.truncations.front());
      return object;
    });
}

const char *explore_budget()
{
  return answer(
    [&]
    {
      std::vector<Json> steps;
      for (const BudgetRow &row : explorer->budget())
        steps.push_back(Json{ { "name", row.name },
                              { "step", row.step.number },
                              { "is_addition", row.step.is_addition },
                              { "harmonics", row.harmonics },
                              { "omega", row.omega_terminal },
                              { "difference", row.difference },
                              { "standing", to_string(row.status) },
                              { "reason", row.reason } });
      return Json{ { "rows", steps } };
    });
}
