#include "fem/pipeline/output/sweep_findings.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// What the console shows.
constexpr const char *main_quantities[] = { "moment ratio",
                                            "contact fraction",
                                            "torque at rest",
                                            "terminal spin",
                                            "terminal spin of the first harmonic alone",
                                            "harmonic effect" };

/// The value of an entry as it counts for sensitivities.
double score_of(const SweepPlan &plan, std::size_t index, std::size_t entry)
{
  const double value = parse_number(plan.cases.at(index)[entry]).value();
  return plan.spreads[entry].is_by_factors() ? std::log(value) : value;
}

/// A quantity over the cases that have it.
struct QuantitySample
{
  std::vector<std::size_t> cases;
  std::vector<double> values;
};

QuantitySample sample_of(const FinishedCases &cases, std::size_t quantity)
{
  QuantitySample sample;
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[quantity])
    {
      sample.cases.push_back(index);
      sample.values.push_back(*result.values[quantity]);
    }
  return sample;
}

QuantityFindings find_out(const SweepPlan &plan, const QuantitySample &sample)
{
  QuantityFindings findings;
  const auto [least, most] = std::minmax_element(sample.values.begin(), sample.values.end());
  const auto case_of = [&](auto place)
  { return sample.cases[static_cast<std::size_t>(place - sample.values.begin())]; };
  findings.n_values = sample.values.size();
  findings.least = *least;
  findings.most = *most;
  findings.least_case = case_of(least);
  findings.most_case = case_of(most);
  if (!plan.is_random() || sample.values.size() < 2)
    return findings;
  findings.band = band_of(sample.values);
  std::vector<std::vector<double>> inputs(plan.entries.size());
  for (std::size_t entry = 0; entry < inputs.size(); ++entry)
    for (const std::size_t index : sample.cases)
      inputs[entry].push_back(score_of(plan, index, entry));
  findings.sensitivity = sensitivity_of(inputs, sample.values);
  return findings;
}

Json sensitivities_as_json(const SweepPlan &plan, const SampleSensitivity &sensitivity)
{
  Json entries = Json::object();
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    entries[plan.entries[i].path] = { { "regression", sensitivity.regression[i] },
                                      { "first_order", sensitivity.first_order[i] } };
  return { { "r_squared", sensitivity.r_squared }, { "entries", entries } };
}

/// "0.27 %", "2110 %".
std::string percent(double value)
{
  return std::abs(value) < 1000 ? formatted("%.3g %%", value) : formatted("%.0f %%", value);
}

/// " (Load/Moment ratio = 1.3)": where something happens.
std::string at_case(const SweepPlan &plan, std::size_t index)
{
  return " (" + values_of_case(plan, index) + ")";
}

std::string spin_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *spin = findings.about("terminal spin");
  if (spin == nullptr)
    return "";
  if (!spin->band)
    return formatted("In %zu cases the glass spins up to between %.6g rad/s", spin->n_values, spin->least) +
           at_case(plan, spin->least_case) + formatted(" and %.6g rad/s", spin->most) +
           at_case(plan, spin->most_case) + ".";
  const SampleBand &band = *spin->band;
  // Where nothing varies, rounding would be shown as a spread.
  const double spread = std::max(band.deviation, 1e-9 * std::abs(band.mean));
  std::string sentence =
    formatted("In %zu samples the glass spins up to %s ± %s rad/s (mean and standard deviation; "
              "95 %% of them lie between %s and %s rad/s).",
              spin->n_values, to_spread(band.mean, spread).c_str(), to_spread(band.deviation, spread).c_str(),
              to_spread(band.lower, spread).c_str(), to_spread(band.upper, spread).c_str());
  if (!spin->sensitivity)
    return sentence;
  const std::vector<double> &shares = spin->sensitivity->first_order;
  const auto largest = std::max_element(shares.begin(), shares.end());
  return sentence + formatted(" %.0f %% of the variance is due to %s alone.", 100 * std::min(*largest, 1.),
                              plan.entries[static_cast<std::size_t>(largest - shares.begin())].path.c_str());
}

std::string harmonic_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *effect = findings.about("harmonic effect");
  if (effect == nullptr || (effect->least == 0 && effect->most == 0))
    return "";
  if (effect->band)
    return " The harmonics of the load beyond the first change it by " + percent(effect->band->mean) +
           " (mean; 95 % of the samples: " + percent(effect->band->lower) + " to " +
           percent(effect->band->upper) + ").";
  std::string sentence;
  if (effect->most > 0)
    sentence += " make it up to " + percent(effect->most) + " faster" + at_case(plan, effect->most_case);
  if (effect->least < 0)
    sentence += (sentence.empty() ? " make it up to " : " and up to ") + percent(-effect->least) + " slower" +
                at_case(plan, effect->least_case);
  return " The harmonics of the load beyond the first" + sentence + ".";
}

std::string closure_sentence(const SweepFindings &findings)
{
  const QuantityFindings *effect = findings.about("closure effect");
  if (effect == nullptr)
    return "";
  const bool is_constant = effect->most - effect->least < 1e-9 * std::abs(effect->most);
  return " For comparison: what the paper's balance of moments leaves out changes the spin of a "
         "first-harmonic load by " +
         (is_constant ? "" : percent(effect->least) + " to ") + percent(effect->most) + ".";
}

std::string failed_cases_sentence(const SweepFindings &findings)
{
  if (findings.n_failed == 0)
    return "";
  return formatted(" %zu of %zu cases failed; the column message of sweep.csv says why.", findings.n_failed,
                   findings.n_cases);
}

} // namespace

const QuantityFindings *SweepFindings::about(const std::string &quantity) const
{
  const std::size_t wanted = quantity_index(quantity);
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [=](const QuantityFindings &findings) { return findings.index == wanted; });
  return found == quantities.end() ? nullptr : &*found;
}

SweepFindings find_out(const SweepPlan &plan, const FinishedCases &cases)
{
  SweepFindings findings;
  findings.n_cases = plan.cases.size();
  for (const auto &[index, result] : cases)
    if (!result.is_solved())
    {
      ++findings.n_failed;
      if (!findings.first_failure)
        findings.first_failure = index;
    }
  for (std::size_t quantity = 0; quantity < sweep_quantities().size(); ++quantity)
  {
    const QuantitySample sample = sample_of(cases, quantity);
    if (sample.values.empty())
      continue;
    findings.quantities.push_back(find_out(plan, sample));
    findings.quantities.back().index = quantity;
  }
  return findings;
}

Json findings_as_json(const SweepPlan &plan, const SweepFindings &findings)
{
  Json quantities = Json::object();
  for (const QuantityFindings &about : findings.quantities)
  {
    const SweepQuantity &quantity = sweep_quantities()[about.index];
    Json one = { { "unit", quantity.unit }, { "values", about.n_values },
                 { "least", about.least },  { "least_case", about.least_case + 1 },
                 { "most", about.most },    { "most_case", about.most_case + 1 } };
    if (about.band)
      one["band"] = { { "mean", about.band->mean },
                      { "standard_deviation", about.band->deviation },
                      { "percentile_2.5", about.band->lower },
                      { "percentile_97.5", about.band->upper } };
    if (about.sensitivity)
      one["sensitivity"] = sensitivities_as_json(plan, *about.sensitivity);
    quantities[quantity.name] = one;
  }
  Json sweep = plan_as_json(plan);
  sweep["failed"] = findings.n_failed;
  return { { "sweep", sweep }, { "quantities", quantities } };
}

std::string statistics_csv(const SweepPlan &plan, const SweepFindings &findings)
{
  std::vector<std::string> titles = { "quantity",
                                      "unit",
                                      "values",
                                      "mean",
                                      "standard deviation",
                                      "2.5 % percentile",
                                      "97.5 % percentile",
                                      "r squared of the linear fit (1)" };
  for (const SweptEntry &entry : plan.entries)
    titles.insert(titles.end(),
                  { "regression on " + entry.path + " (1)", "first-order share of " + entry.path + " (1)" });
  std::string table = csv_record(titles);
  for (const QuantityFindings &about : findings.quantities)
  {
    if (!about.band)
      continue;
    const SweepQuantity &quantity = sweep_quantities()[about.index];
    std::vector<std::string> fields = { quantity.name, quantity.unit, std::to_string(about.n_values) };
    for (const double value :
         { about.band->mean, about.band->deviation, about.band->lower, about.band->upper })
      fields.push_back(to_text(value));
    fields.push_back(about.sensitivity ? to_text(about.sensitivity->r_squared) : "");
    for (std::size_t i = 0; i < plan.entries.size(); ++i)
    {
      fields.push_back(about.sensitivity ? to_text(about.sensitivity->regression[i]) : "");
      fields.push_back(about.sensitivity ? to_text(about.sensitivity->first_order[i]) : "");
    }
    table += csv_record(fields);
  }
  return table;
}

std::string sweep_answer(const SweepPlan &plan, const SweepFindings &findings)
{
  return spin_sentence(plan, findings) + harmonic_sentence(plan, findings) + closure_sentence(findings) +
         failed_cases_sentence(findings);
}

std::string findings_table(const SweepFindings &findings)
{
  TextColumn quantity = { "quantity", {}, true };
  std::vector<TextColumn> columns = { { "least", {} }, { "mean", {} },
                                      { "most", {} },  { "standard\ndeviation", {} },
                                      { "2.5 %", {} }, { "97.5 %", {} } };
  bool has_bands = false;
  for (const char *name : main_quantities)
    if (const QuantityFindings *about = findings.about(name))
    {
      quantity.cells.push_back(column_title(name, sweep_quantities()[about->index].unit));
      const SampleBand band = about->band.value_or(SampleBand());
      has_bands = has_bands || about->band;
      const double cells[] = { about->least, band.mean, about->most, band.deviation, band.lower, band.upper };
      for (std::size_t c = 0; c < columns.size(); ++c)
        columns[c].cells.push_back(formatted("%.6g", cells[c]));
    }
  if (!has_bands)
    columns = { columns[0], columns[2] };
  columns.insert(columns.begin(), quantity);
  return text_table(columns);
}

std::string values_of_case(const SweepPlan &plan, std::size_t index)
{
  std::string text;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const std::string &value = plan.cases.at(index)[i];
    const auto number = plan.entries[i].unit.empty() ? std::nullopt : parse_number(value);
    text += (i == 0 ? "" : ", ") + plan.entries[i].path + " = " + (number ? to_short_text(*number) : value);
  }
  return text;
}

} // namespace stemware::pipeline
