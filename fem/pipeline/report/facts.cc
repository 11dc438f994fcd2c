#include "fem/pipeline/report/facts.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/document/budget_rows.h"
#include "fem/pipeline/document/number_format.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

bool is_one_way(const Study &study)
{
  return study.load.source == LoadSource::file || study.load.is_static() ||
         (study.load.is_from_contact() && study.load.coupling == LoadCoupling::one_way);
}

Json study_facts(const Study &study)
{
  return { { "one_way", is_one_way(study) },
           { "given_load", study.load.source == LoadSource::file },
           { "given_moment", study.load.is_static() } };
}

Json spin_facts(const Study &study, double omega)
{
  constexpr double turn = boost::math::double_constants::two_pi;
  const bool is_with_orbit = omega * study.motion.orbit.sense_sign() > 0;
  return { { "omega", omega },
           { "size", std::abs(omega) },
           { "sense", std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
                        (is_with_orbit ? "with" : "against") + " its orbit" },
           { "seconds_a_turn", turn / std::abs(omega) },
           { "turns_a_second", std::abs(omega) / turn } };
}

Json effect_facts(const Study &study, const HarmonicEffect &effect)
{
  if (!effect.absolute)
    return nullptr;
  return { { "absolute", *effect.absolute },
           { "relative", effect.relative ? faster_or_slower(*effect.relative) : "" },
           { "is_small", !is_spin(study, *effect.absolute) },
           { "rounding", rounding_of_spins(study) } };
}

Json lift_off_facts(const std::vector<std::pair<std::string, const LoadReport *>> &states)
{
  Json facts = Json::array();
  for (const auto &[state, load] : states)
    if (load->minimum < 0 || load->contact_fraction < 1)
      facts.push_back({ { "state", state },
                        { "least", load->minimum },
                        { "share", load->contact_fraction },
                        { "moment_ratio", load->moment_ratio },
                        { "pulls", load->minimum < 0 },
                        { "above_one", load->moment_ratio > 1 } });
  return facts;
}

std::string faster_or_slower(double change)
{
  return format::number(std::abs(change), ".3g%") + (change > 0 ? " faster" : " slower");
}

} // namespace stemware::pipeline
