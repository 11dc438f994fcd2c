#include "fem/pipeline/report/terminal_spins.h"

#include "fem/pipeline/report/render/number_format.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

bool is_reached(const ring::TerminalSpin &one, const SpinStudy &spin)
{
  return spin.all().terminal && one.omega == spin.all().terminal->omega;
}

std::string stability_of(const ring::TerminalSpin &one)
{
  return one.held ? "held by the fingers" : one.stable ? "stable" : "unstable";
}

std::optional<double> if_finite(double value)
{
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

Table terminal_spins_table(const SpinStudy &spin)
{
  std::vector<std::vector<std::string>> rows;
  for (const ring::TerminalSpin &one : spin.terminal_spins)
    rows.push_back({ format::significant<7>(one.omega), stability_of(one),
                     std::isfinite(one.time_constant) ? format::significant<4>(one.time_constant) : "–",
                     is_reached(one, spin) ? "reached from rest" : "" });
  return words("", { "spin ω (rad/s)", "", "time constant (s)", "" }, rows);
}

nlohmann::ordered_json terminal_spins_summary(const SpinStudy &spin)
{
  nlohmann::ordered_json spins = nlohmann::ordered_json::array();
  for (const ring::TerminalSpin &one : spin.terminal_spins)
    spins.push_back({ { "omega", one.omega },
                      { "stable", one.stable },
                      { "held", one.held },
                      { "torque_slope", json_number(if_finite(one.torque_slope)) },
                      { "time_constant", json_number(if_finite(one.time_constant)) },
                      { "from_rest", is_reached(one, spin) } });
  return spins;
}

} // namespace stemware::pipeline
