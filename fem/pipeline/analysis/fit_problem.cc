#include "fem/pipeline/analysis/fit_problem.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/variants/solve.h"

#include <unsupported/Eigen/NonLinearOptimization>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

boost::math::interpolators::cardinal_cubic_b_spline<double>
spline(const std::vector<ring::YawSample> &samples, double ring::YawSample::*value, double step)
{
  std::vector<double> values;
  for (const ring::YawSample &sample : samples)
    values.push_back(sample.*value);
  return { values.begin(), values.end(), 0., step };
}

} // namespace

FitParameter fit_parameter(const Study &study, const FreeEntry &free)
{
  const std::vector<StudyEntry> entries = entries_of(study);
  const StudyEntry &entry = entry_at(entries, "--free ", free.path);
  FitParameter parameter = { entry.path(), entry.name, entry.unit };
  const double given = free.prior ? free.prior->value : std::get<double>(entry.value());
  const double usual = entry.plausible ? std::max(std::abs(entry.plausible->min), entry.plausible->max) : 1;
  parameter.is_log = !entry.assign("0"); // of a copy
  parameter.is_never_negative = !parameter.is_log && !entry.assign("-1e-9");
  require(!parameter.is_log || given > 0, "--free " + entry.path() + ": the value is not greater than 0.");
  parameter.scale = parameter.is_log ? 1 : given != 0 ? std::abs(given) : usual / 100;
  parameter.start = parameter.is_log ? std::log(given) : given / parameter.scale;
  parameter.prior = parameter.start;
  if (free.prior)
    parameter.prior_spread = free.prior->spread / (parameter.is_log ? given : parameter.scale);
  return parameter;
}

Study with_parameters(Study study, const std::vector<FitParameter> &parameters, const VectorXd &x)
{
  const std::vector<StudyEntry> entries = study_entries(study);
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    const StudyEntry &entry = entry_at(entries, "--free ", parameters[j].path);
    const double value = parameters[j].value(x(static_cast<Index>(j)));
    if (!entry.assign(to_text(value)))
      assign(entry, "--free ", to_text(std::abs(value)));
  }
  check_values(study);
  return study;
}

SpinUp::SpinUp(const std::vector<ring::YawSample> &samples, double step)
    : end(step * static_cast<double>(samples.size() - 1))
    , last(samples.back())
    , omega(spline(samples, &ring::YawSample::omega, step))
    , angle(spline(samples, &ring::YawSample::yaw_angle, step))
{
}

const SpinUp &SpinUps::at(const VectorXd &x)
{
  const std::vector<double> key(x.begin(), x.end());
  const auto known = spin_ups.find(key);
  return known != spin_ups.end() ? known->second : spin_ups.emplace(key, find(x)).first->second;
}

SpinUp SpinUps::find(const VectorXd &x)
{
  constexpr int n_steps = 1200;
  constexpr double n_time_constants = 60; // of the spin without grip
  const Study now = with_parameters(study, parameters, x);
  const ring::SharedLoad load = load_of(now, x);
  const ring::Motion &motion = now.motion.orbit;
  const double torque = motion.friction_at_rest() * motion.normal_force() * load->radius(),
               step = n_time_constants / n_steps * motion.yaw_inertia * load->spin_scale(motion) / torque;
  ring::Question question = spin_question(now);
  question.with_minima = false;
  for (int i = 0; i <= n_steps; ++i)
    question.times.push_back(i * step);
  const ring::Answer found = ring::answer(*load, question).value();
  if (found.fall)
    throw ring::NoBalance(found.reason);
  return { found.spin_up, step };
}

ring::SharedLoad SpinUps::load_of(const Study &now, const VectorXd &x)
{
  std::vector<double> key;
  bool on_same_foot = true;
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    const std::string &path = parameters[j].path;
    if (path == "Motion/Grip torque" || path == "Motion/Yaw inertia")
      continue;
    key.push_back(x(static_cast<Index>(j)));
    on_same_foot = on_same_foot && path.rfind("Motion/", 0) == 0;
  }
  ring::SharedLoad &load = loads[key];
  if (load)
    return load;
  Variant variant = { "", "", now };
  variant.on_same_foot = on_same_foot && foot;
  const std::shared_ptr<ElasticFoot> own = foot_of(variant, foot, executor);
  const ring::SharedLoad exact = find_load(now, own);
  if (!foot)
    foot = own;
  if (!exact->is_costly())
    return load = exact;
  ring::Question free = spin_question(now);
  free.grip_torque = 0;
  free.with_minima = false;
  const double last = ring::answer(*exact, free).value().last_spin().value();
  return load = ring::interpolated(exact, std::min(0., 1.001 * last), std::max(0., 1.001 * last));
}

FitProblem::FitProblem(const std::vector<FitParameter> &parameters, std::vector<PreparedRun> all_runs,
                       const Prior &gyroscope_zero)
    : runs(std::move(all_runs))
    , n_parameters(static_cast<Index>(parameters.size()))
    , priors(n_parameters + 2 * static_cast<Index>(runs.size()))
    , spreads(priors.size())
{
  for (Index j = 0; j < n_parameters; ++j)
  {
    priors(j) = parameters[static_cast<std::size_t>(j)].prior;
    spreads(j) = parameters[static_cast<std::size_t>(j)].prior_spread;
  }
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const MeasuredRun &data = runs[r].given.data;
    const bool is_angle = data.is_angle;
    priors.segment<2>(of_run(r)) << data.times.front() / runs[r].time_scale,
      is_angle ? data.values.front() : gyroscope_zero.value;
    constexpr double fixed = 1e-9, any_turns = 1e4;
    spreads.segment<2>(of_run(r)) << 100 + (data.times.back() - data.times.front()) / runs[r].time_scale,
      is_angle ? any_turns : std::max(gyroscope_zero.spread, fixed);
  }
}

Index FitProblem::n_points() const
{
  Index n = 0;
  for (const PreparedRun &run : runs)
    n += run.n_points();
  return n;
}

int FitProblem::operator()(const VectorXd &x, VectorXd &residuals) const
{
  constexpr double too_large = 1e6;
  residuals.setConstant(values(), too_large);
  try
  {
    Index row = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
    {
      const SpinUp &spin_up = runs[r].spin_ups->at(x.head(n_parameters));
      const double start = x(of_run(r)) * runs[r].time_scale, zero = x(of_run(r) + 1);
      for (Index i = 0; i < runs[r].n_points(); ++i, ++row)
        residuals(row) =
          (runs[r].model(spin_up, i, start) + zero - runs[r].given.data.values[static_cast<std::size_t>(i)]) /
          runs[r].noise;
    }
    residuals.segment(row, inputs()) = (x - priors).cwiseQuotient(spreads);
    residuals(values() - 1) = held ? (x(held->first) - held->second) / held_to : 0;
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
  }
  return 0;
}

int FitProblem::df(const VectorXd &x, MatrixXd &jacobian) const
{
  jacobian.setZero(values(), inputs());
  try
  {
    add_derivatives(x, jacobian);
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
    jacobian.setZero();
  }
  return 0;
}

void FitProblem::add_derivatives(const VectorXd &x, MatrixXd &jacobian) const
{
  constexpr double step = 1e-3;
  Index row = 0;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const PreparedRun &run = runs[r];
    const SpinUp &spin_up = run.spin_ups->at(x.head(n_parameters));
    const double start = x(of_run(r)) * run.time_scale;
    for (Index j = 0; j < n_parameters; ++j)
    {
      VectorXd moved = x.head(n_parameters);
      const SpinUp *other = nullptr;
      for (const double way : { step, -step }) // one of them may be beyond a fall
        try
        {
          moved(j) = x(j) + way;
          other = other ? other : &run.spin_ups->at(moved);
          if (moved(j) == x(j) + way && other == &run.spin_ups->at(moved))
          {
            for (Index i = 0; i < run.n_points(); ++i)
              jacobian(row + i, j) =
                (run.model(*other, i, start) - run.model(spin_up, i, start)) / (way * run.noise);
            break;
          }
        }
        catch (const std::exception &failure)
        {
          if (!is_variant_failure(failure))
            throw;
        }
    }
    for (Index i = 0; i < run.n_points(); ++i)
    {
      const double time = run.given.data.times[static_cast<std::size_t>(i)] - start;
      jacobian(row + i, of_run(r)) =
        -run.time_scale / run.noise *
        (run.given.data.is_angle ? spin_up.spin(time) : spin_up.acceleration(time));
      jacobian(row + i, of_run(r) + 1) = 1 / run.noise;
    }
    row += run.n_points();
  }
  jacobian.block(row, 0, inputs(), inputs()) = spreads.cwiseInverse().asDiagonal();
  if (held)
    jacobian(values() - 1, held->first) = 1 / held_to;
}

double FitProblem::chi_square(const VectorXd &x) const
{
  VectorXd residuals;
  (*this)(x, residuals);
  return residuals.head(values() - 1).squaredNorm();
}

VectorXd FitProblem::minimum(VectorXd x)
{
  Eigen::LevenbergMarquardt<FitProblem> search(*this);
  search.parameters.xtol = 1e-7;
  search.parameters.ftol = 1e-9;
  search.parameters.maxfev = 100;
  search.minimize(x);
  return x;
}

double widening(double correlation, Eigen::Index n)
{
  const bool is_chance = correlation < 2 / std::sqrt(static_cast<double>(n));
  return is_chance ? 1 : (1 + correlation) / (1 - std::min(correlation, 0.99));
}

} // namespace stemware::pipeline
