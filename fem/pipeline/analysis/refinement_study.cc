#include "fem/pipeline/analysis/refinement_study.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_file.h"
#include "ring_model/spin/answer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

struct Parameter
{
  RefinementAxis axis;
  unsigned int &value;
  unsigned int min, max;
  unsigned int step = 0; ///< sizes: multiples of `step`, doubled at each level; 0: sizes increase by one
};

std::vector<Parameter> parameters_of(ContactSection &contact)
{
  fem::FootResolution &cells = contact.resolution;
  const RefinementAxis of_degree = { "degree", "degree of the elements", "degree", AxisKind::degree },
                       of_harmonics = { "harmonics", "elastic harmonics", "harmonics", AxisKind::azimuth },
                       of_lines = { "azimuth_lines", "azimuth lines", "lines", AxisKind::azimuth };
  const Parameter degree = { of_degree, contact.degree, 1, contact.highest_degree() };
  if (contact.is_of_revolution())
    return {
      { { "meridional_mesh", "meridional mesh", "halvings of every cell" }, contact.refinements, 0, 6 },
      degree,
      { of_harmonics, contact.harmonics, 1, (contact.azimuth_lines - 1) / 2, 1 },
      { of_lines, contact.azimuth_lines, std::max(16u, 2 * contact.harmonics + 1), 1000000, 1 }
    };
  if (!contact.mesh_file.empty())
    return { degree };
  return { { { "azimuthal_cells", "cells round the rim", "cells" }, cells.azimuthal_cells, 8, 2000, 4 },
           { { "radial_cells", "cells across the land", "cells" }, cells.radial_cells, 2, 200, 2 },
           { { "foot_layers", "cells through the foot", "cells" }, cells.foot_layers, 1, 100, 1 },
           degree };
}

} // namespace

std::vector<RefinementAxis> refinement_axes(Study study, unsigned int n_levels)
{
  ensure(study.load.is_from_contact(), "This study's load does not come from a contact, so it has no "
                                       "discretisation to refine; set Load/Source = contact.");
  ensure(!study.has_waviness(), "A refinement study needs a flat rim and a flat table; leave Glass/Rim "
                                "waviness and Table/Waviness empty.");
  ensure(study.contact.goal == Goal::none,
         "Contact/Goal makes its own mesh, without coarser and finer levels; set Contact/Goal = none.");
  std::vector<RefinementAxis> axes;
  for (auto &[axis, value, min, max, step] : parameters_of(study.contact))
  {
    const unsigned int own = value, n = axis.kind == AxisKind::degree ? max : n_levels;
    const auto add = [&, &axis = axis, &value = value](unsigned int size)
    {
      value = size;
      check_study(study);
      axis.sizes.push_back(size);
      axis.levels.push_back(
        { { study }, VariantKind::parameter, std::to_string(size) + " of the refinement in " + axis.key });
    };
    if (step > 0 ? own % (2 * step) == 0 && own / 2 >= min : own > min)
      add(step > 0 ? own / 2 : own - 1);
    axis.own = axis.levels.size();
    for (unsigned int size = own; axis.levels.size() < n && (size == own || size <= max);
         size = step > 0 ? 2 * size : size + 1)
      add(size);
    value = own;
    if (axis.levels.size() > 1)
      axes.push_back(axis);
  }
  return axes;
}

RefinementSequence assess_convergence(const std::vector<double> &values, AxisKind kind, double rounding)
{
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (values.empty() || !std::all_of(values.begin(), values.end(), is_finite))
    throw std::invalid_argument("A refinement study needs finite values.");
  const std::size_t n = values.size();
  const double fine_step = n > 1 ? values[n - 1] - values[n - 2] : 0,
               coarse_step = n > 2 ? values[n - 2] - values[n - 3] : 0;
  const bool has_order = std::abs(fine_step) > rounding && coarse_step * fine_step > 0;
  const double order = has_order ? std::log2(coarse_step / fine_step) : 0;
  RefinementSequence sequence = { values, std::nullopt, values.back(), {} };
  double band = rounding;
  if (kind != AxisKind::cells)
    band +=
      // The last difference may be small by chance, so at least a quarter of the previous one is used.
      1.25 * std::max(std::abs(fine_step), std::abs(coarse_step) / 4);
  else if (0.5 <= order && order <= 8)
  {
    sequence.order = order;
    sequence.limit += fine_step / (std::exp2(order) - 1);
    band += 1.25 * std::abs(fine_step) / (std::exp2(std::min(order, 1.)) - 1);
  }
  else
  {
    const auto last_three = values.end() - static_cast<std::ptrdiff_t>(std::min<std::size_t>(n, 3));
    const auto [least, largest] = std::minmax_element(last_three, values.end());
    band += (n == 2 ? 1.5 : 3.) * (*largest - *least); // with two levels, first order is assumed
  }
  for (const double value : values)
    sequence.bands.push_back(std::abs(value - values.back()) + band);
  return sequence;
}

ErrorBands refine(const std::vector<QuantityOfInterest> &own, std::vector<RefinementAxis> &axes,
                  const Executor &executor)
{
  std::vector<double> spins;
  for (const QuantityOfInterest &quantity : own)
    if (quantity.omega)
      spins.push_back(*quantity.omega);
  const double near = quantity_of(own, "omega_terminal").value;
  std::vector<Variant> open; // all levels except the study itself
  for (const RefinementAxis &axis : axes)
    for (std::size_t l = 0; l < axis.levels.size(); ++l)
      if (l != axis.own)
        open.push_back(axis.levels[l]);
  const auto quantities_at = [&](const Variant &level, const std::shared_ptr<ElasticFoot> &foot)
  { return quantities_of_load(level.study, find_load(level.study, foot), spins, near); };
  const auto solved = solve(open, nullptr, quantities_at, executor,
                            counting_callback(executor.progress, "levels", open.size()));
  for (std::size_t i = 0; i < open.size(); ++i)
    if (solved[i].failure)
      throw ring::NoBalance("Level " + open[i].name + ": " + ring::failed_answer(solved[i].failure).reason);

  ErrorBands bands;
  for (std::size_t q = 0; q < own.size(); ++q)
  {
    BandedQuantity &banded = bands.emplace_back(BandedQuantity{ own[q], own[q].rounding, own[q].value });
    double cells = 0, degree = 0;
    auto level = solved.begin();
    for (RefinementAxis &axis : axes)
    {
      std::vector<double> values;
      double rounding = own[q].rounding;
      for (std::size_t l = 0; l < axis.levels.size(); ++l)
      {
        const QuantityOfInterest &quantity = l == axis.own ? own[q] : (*level++->answer)[q];
        values.push_back(quantity.value);
        rounding = std::max(rounding, quantity.rounding);
      }
      RefinementSequence &judged =
        axis.quantities.emplace_back(assess_convergence(values, axis.kind, rounding));
      judged.key = own[q].key;
      const bool has_finer = axis.own + 1 < axis.levels.size();
      if (axis.kind == AxisKind::degree)
        degree = has_finer ? judged.bands[axis.own] : 0;
      else
        (axis.kind == AxisKind::cells ? cells : banded.band) += judged.bands[axis.own];
      if (axis.kind != AxisKind::degree && has_finer)
        banded.richardson += judged.limit - own[q].value;
    }
    banded.band += std::max(cells, degree);
  }
  return bands;
}

} // namespace stemware::pipeline
