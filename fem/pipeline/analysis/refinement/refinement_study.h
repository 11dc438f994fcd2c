#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/variants/refinement_axis.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Limit of values on ever finer levels, with the observed order and the error.
struct RefinementSequence
{
  std::optional<double> order; ///< observed p of the last three values; nothing where they do not show one
  double limit = 0;            ///< Richardson value where an order was observed, else the finest value
  double uncertainty = 0;      ///< half-width of the band round the finest value that holds the exact one
  std::vector<double> bands;   ///< the same for every level: its distance from the finest value is added
};

/// Judges @p values, from the coarsest level to the finest; @p rounding is the size of differences that say
/// nothing (solver tolerances).
///
/// *Algebraic decay.* Three values that approach their limit from one side have the observed order p =
/// log2((v_1 - v_0) / (v_2 - v_1)). Where that is plausible, 0.5 <= p <= 8, the limit is Richardson's, and
/// the band is the grid convergence index 1.25 |v_2 - v_1| / (2^min(p, 1) - 1) (Roache, J. Fluids Eng. 116
/// (1994) 405, doi 10.1115/1.2910291; Celik et al., J. Fluids Eng. 130 (2008) 078001, doi 10.1115/1.2960953).
/// What turns round, hardly converges, or ends with a step too small to be believed gets three times the
/// range of the last three values (Eca & Hoekstra, J. Comput. Phys. 262 (2014) 104,
/// doi 10.1016/j.jcp.2014.01.006). Two values are taken as first order with the factor 1.5.
///
/// *Spectral decay.* The band is the last difference times 1.25, or a quarter of the one before where that is
/// larger: one small difference may be chance.
///
/// Throws std::invalid_argument without a value, or for one that is not finite.
RefinementSequence judge_refinement(const std::vector<double> &values, Decay decay, double rounding);

/// One quantity along one axis.
struct QuantitySequence
{
  std::vector<double> values; ///< one per level
  RefinementSequence judged;
  /// QuantityOfInterest::mesh_correction, one per level; empty where none is estimated.
  std::vector<std::optional<double>> corrections = {};

  /// The error of level @p l against the level two further on, with what is missing there where that is
  /// estimated; nothing on the last two levels.
  std::optional<double> error(std::size_t l) const;
  /// The correction over that error; nothing where the error is no more than @p rounding.
  std::optional<double> effectivity(std::size_t l, double rounding) const;
};

/// One axis with what was found on it.
struct AxisResult
{
  RefinementAxis axis;
  std::vector<QuantitySequence> quantities; ///< one per quantity
};

/// A refinement study: every axis, and the bands that they make together.
struct RefinementResult
{
  std::vector<AxisResult> axes;
  ErrorBands quantities;
};

/// Solves @p axes around the study whose own quantities are @p own, with the torque followed at @p spins:
/// axis by axis, level by level, each with its own foot, load and terminal spin. @p progress is told of the
/// levels.
///
/// The band of a quantity is the sum over the axes in space of the study's own bands there, or the band
/// of the degree where that has finer levels and is wider, plus the bands of harmonics and lines. Throws what
/// the first level that fails throws, with the level named in front.
RefinementResult refine(const std::vector<QuantityOfInterest> &own, const std::vector<double> &spins,
                        const std::vector<RefinementAxis> &axes, const Executor &executor,
                        Progress &progress = silent_progress());

/// Quantities of a study whose load is known, with the torque at @p spins [rad/s]; with @p foot, of terminal
/// spin and a_2 what the mesh does to them. @p near, where given, is a spin close to the terminal one, from
/// which it is searched. Throws as @p load and ring::terminal_spin().
std::vector<QuantityOfInterest> quantities_of_load(const Study &study, const BalancedLoad &load,
                                                   const std::vector<double> &spins,
                                                   const std::optional<double> &near,
                                                   const ElasticFoot *foot = nullptr);

} // namespace stemware::pipeline
