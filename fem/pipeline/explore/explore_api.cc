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
#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

namespace
{

std::unique_ptr<Explorer> explorer = std::make_unique<Explorer>(); // NOLINT: a page has one
std::optional<fem::ContactState> last_contact;                     // NOLINT
std::string reply;                                                 // NOLINT: what the page reads

std::string json(double value)
{
  if (!std::isfinite(value))
    return "null";
  // Not the shortest text: where the standard library does not have it, that takes seventeen trials.
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::string json(bool value)
{
  return value ? "true" : "false";
}

std::string json(unsigned int value)
{
  return std::to_string(value);
}

std::string json(const std::string &text)
{
  std::string result = "\"";
  for (const char letter : text)
    if (letter == '"' || letter == '\\')
      result += std::string("\\") + letter;
    else
      result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  return result + '"';
}

std::string json(const char *text)
{
  return json(std::string(text));
}

std::string json(const Eigen::Vector2d &vector)
{
  return '[' + json(vector.x()) + ',' + json(vector.y()) + ']';
}

template <typename Value>
std::string json(const std::optional<Value> &value)
{
  return value ? json(*value) : "null";
}

template <typename Value>
std::string json(const std::vector<Value> &values)
{
  std::string text;
  for (const Value &value : values)
    text += (text.empty() ? "[" : ",") + json(value);
  return text.empty() ? "[]" : text + ']';
}

/// Text that is JSON already.
struct Made
{
  std::string text;
};

std::string json(const Made &made)
{
  return made.text;
}

/// A JSON object that grows.
class Object
{
public:
  template <typename Value>
  Object &add(const std::string &key, const Value &value)
  {
    text += (text.empty() ? "{" : ",") + json(key) + ':' + json(value);
    return *this;
  }
  Made made() const { return { text.empty() ? "{}" : text + '}' }; }

private:
  std::string text;
};

/// State of the rim: its load by harmonics, friction and torques.
Made state_json(const RingState &state, double contact_radius)
{
  const ring::RingStack &load = state.load;
  std::vector<double> a, b;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    a.push_back(load.a(n));
    b.push_back(load.b(n));
  }
  return Object()
    .add("a", a)
    .add("b", b)
    .add("normal_force", load.normal_force())
    .add("moment", Eigen::Vector2d(load.moment()))
    .add("moment_ratio", load.moment_ratio(contact_radius))
    .add("friction", std::vector<double>{ state.friction.force_x, state.friction.force_y })
    .add("torque", state.friction.torque)
    .add("lean_torque", state.lean_torque)
    .add("grip_torque", state.grip_torque)
    .add("minimum", state.minimum)
    .add("pulling_share", state.pulling_share)
    .made();
}

Made row_json(const SpinRow &row, double contact_radius)
{
  Object object;
  object.add("omega", row.omega_terminal())
    .add("last_spin", row.last_spin())
    .add("falls", row.fall.has_value())
    .add("time_constant", row.time_constant())
    .add("harmonics", row.harmonics)
    .add("standing", to_string(row.standing))
    .add("contact_fraction", row.contact_fraction)
    .add("reason", row.reason);
  if (row.at_rest)
    object.add("at_rest", state_json(*row.at_rest, contact_radius));
  if (row.at_terminal)
    object.add("at_end", state_json(*row.at_terminal, contact_radius));
  else if (row.fall)
    object.add("at_end", state_json(row.fall->state, contact_radius));
  return object.made();
}

Made contact_json(const fem::ContactState &contact)
{
  std::vector<double> azimuths, loads;
  for (const fem::AzimuthLoad &place : contact.load.pointwise)
  {
    azimuths.push_back(place.azimuth);
    loads.push_back(place.density);
  }
  return Object()
    .add("azimuth", azimuths)
    .add("load", loads)
    .add("inner_radius", contact.inner_radius)
    .add("outer_radius", contact.outer_radius)
    .add("motion", std::vector<double>(contact.solution.motion.begin(), contact.solution.motion.end()))
    .add("contact_fraction", contact.load.contact_fraction)
    .made();
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
    reply = Object().add("error", failure.what()).add("tips", true).made().text;
  }
  catch (const fem::ContactFailure &failure)
  {
    const bool tips = failure.outcome == fem::ContactOutcome::tipping;
    reply = Object().add("error", failure.what()).add("tips", tips).made().text;
  }
  catch (const std::exception &failure)
  {
    reply = Object().add("error", failure.what()).add("tips", false).made().text;
  }
  return reply.c_str();
}

const char *name_of(MeshFit fit)
{
  return fit == MeshFit::same ? "same" : fit == MeshFit::near ? "near" : "foreign";
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
  explorer->take(std::make_shared<const fem::ContactCompliance>(unpacked(numbers)), is_disc != 0);
}

const char *explore_set(const char *path, const char *value)
{
  return answer(
    [&]
    {
      explorer->set(path, value);
      return Object().made();
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
      std::vector<Made> entries;
      for (const StudyEntry &entry : study_entries(copy))
        entries.push_back(Object()
                            .add("path", entry.path())
                            .add("unit", entry.unit)
                            .add("allowed", entry.allowed)
                            .add("help", entry.help)
                            .add("value", entry.text())
                            .add("acts", entry.has_effect)
                            .made());
      return Made{ json(entries) };
    });
}

const char *explore_solve(unsigned int n_harmonics, int cold)
{
  return answer(
    [&]
    {
      const LiveAnswer found = explorer->solve(n_harmonics == 0 ? all_harmonics : n_harmonics, cold != 0);
      last_contact = found.contact;
      Object object;
      object.add("fit", name_of(found.fit))
        .add("contact_radius", found.contact_radius)
        .add("all", row_json(found.all, found.contact_radius))
        .add("paper", row_json(found.paper, found.contact_radius))
        .add("notes", implausible_notes(explorer->study()));
      if (found.first_n)
        object.add("first_n", row_json(*found.first_n, found.contact_radius));
      if (found.contact)
        object.add("contact", contact_json(*found.contact));
      return object.made();
    });
}

const char *explore_pressure(unsigned int n_azimuths)
{
  return answer(
    [&]
    {
      if (!last_contact)
        return Object().made();
      const fem::PressureMap map = explorer->pressure(*last_contact);
      const std::size_t step = std::max<std::size_t>(1, map.cuts.size() / std::max(1u, n_azimuths));
      std::vector<double> azimuths;
      std::vector<Made> cuts;
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
        cuts.push_back({ "[" + radii + "]," + pressures + "]]" });
      }
      return Object().add("azimuth", azimuths).add("cuts", cuts).made();
    });
}

const char *explore_curves()
{
  return answer(
    [&]
    {
      const std::optional<LiveCurves> curves = explorer->curves();
      if (!curves)
        return Object().made();
      const TorqueCurve &torque = curves->torque;
      std::vector<double> of_all;
      for (const ring::Wrench &friction : torque.friction)
        of_all.push_back(friction.torque);
      Object object;
      object.add("spin", torque.omega)
        .add("torque", of_all)
        .add("sum", torque.sum)
        .add("of_paper", curves->of_paper)
        .add("time", curves->time)
        .add("omega", curves->spin)
        .add("omega_n", curves->spin_n)
        .add("omega_paper", curves->spin_paper);
      if (!torque.truncations.empty())
        object.add("of_n", torque.truncations.front());
      return object.made();
    });
}

const char *explore_budget()
{
  return answer(
    [&]
    {
      std::vector<Made> steps;
      for (const BudgetRow &row : explorer->budget())
        steps.push_back(Object()
                          .add("name", row.name)
                          .add("step", row.step.number)
                          .add("is_addition", row.step.is_addition)
                          .add("harmonics", row.harmonics)
                          .add("omega", row.omega_terminal)
                          .add("difference", row.difference)
                          .add("standing", to_string(row.standing))
                          .add("reason", row.reason)
                          .made());
      return Object().add("rows", steps).made();
    });
}
