#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/refinement/refinement_sequence.h"
#include "fem/pipeline/variants/solve.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

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
