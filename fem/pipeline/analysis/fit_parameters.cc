#include "fem/pipeline/analysis/fit_parameters.h"

#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <cstddef>
#include <variant>

namespace stemware::pipeline
{

FitParameter fit_parameter(const Study &study, const FreeEntry &free)
{
  const std::vector<StudyEntry> entries = entries_of(study);
  const StudyEntry &entry = entry_at(entries, "--free ", free.path);
  FitParameter parameter = { entry.path(), entry.name, entry.unit };
  const double given = free.prior ? free.prior->value : std::get<double>(entry.value());
  const double usual = entry.plausible ? std::max(std::abs(entry.plausible->min), entry.plausible->max) : 1;
  parameter.is_log = !entry.assign("0"); // of a copy
  parameter.is_never_negative = !parameter.is_log && !entry.assign("-1e-9");
  ensure(!parameter.is_log || given > 0, "--free " + entry.path() + ": the value is not greater than 0.");
  parameter.scale = parameter.is_log ? 1 : given != 0 ? std::abs(given) : usual / 100;
  parameter.start = parameter.is_log ? std::log(given) : given / parameter.scale;
  parameter.prior = parameter.start;
  if (free.prior)
    parameter.prior_spread = free.prior->spread / (parameter.is_log ? given : parameter.scale);
  return parameter;
}

MovedStudy::MovedStudy(const Study &study, const std::vector<FitParameter> &parameters)
    : now(study)
    , entries(study_entries(now))
    , parameters(parameters)
{
}

const Study &MovedStudy::at(const Eigen::VectorXd &x)
{
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    const StudyEntry &entry = entry_at(entries, "--free ", parameters[j].path);
    const double value = parameters[j].value(x(static_cast<Eigen::Index>(j)));
    if (!entry.assign(to_text(value)))
      assign(entry, "--free ", to_text(std::abs(value)));
  }
  check_values(now);
  return now;
}

Study with_parameters(const Study &study, const std::vector<FitParameter> &parameters,
                      const Eigen::VectorXd &x)
{
  return MovedStudy(study, parameters).at(x);
}

} // namespace stemware::pipeline
