#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/refinement/refinement_axis.h"

#include <functional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// One quantity along one axis.
struct FigureSequence
{
  std::vector<double> values; ///< one per level
  RefinementSequence judged;
};

/// One axis with what was found on it.
struct AxisResult
{
  RefinementAxis axis;
  std::vector<FigureSequence> figures; ///< one per quantity
};

/// A refinement study: every axis, and the bands that they make together.
struct RefinementResult
{
  std::vector<AxisResult> axes;
  std::vector<BandedFigure> figures;

  const BandedFigure &figure(const std::string &key) const; ///< throws std::out_of_range
};

/// Called after each solved level with the number of levels solved and of all of them; from one thread at a
/// time.
using RefinementProgress = std::function<void(std::size_t n_done, std::size_t n_all)>;

/// Solves @p axes around the study whose own figures are @p own, with the torque followed at @p spins. Bodies
/// of revolution are solved by @p n_threads threads side by side, solid bodies one after the other by all
/// ranks.
///
/// The band of a quantity is the sum over the axes in space of the study's own bands there, or the band
/// of the degree where that has finer levels and is wider, plus the bands of harmonics and lines. Throws what
/// the first level that fails throws, with the level named in front.
RefinementResult refine(const Study &study, const std::vector<FollowedFigure> &own,
                        const std::vector<double> &spins, const std::vector<RefinementAxis> &axes,
                        unsigned int n_threads, const RefinementProgress &progress = {});

/// Figures of a study whose load is known.
std::vector<FollowedFigure> figures_of_load(const Study &study, const RingLoad &load,
                                            const std::vector<double> &spins,
                                            const std::optional<double> &near);

/// Whether estimate_error_bands() costs little beside the study itself: a body of revolution on a mat or a
/// rough table. Where the contact is as narrow as Hertz makes it, finer meshes take seconds.
bool has_quick_error_bands(const Study &study);

/// The error bands of a body of revolution's figures by the fewest further contact problems (quick_axes()).
/// @p load is the study's own, @p omega_terminal its terminal spin.
RefinementResult estimate_error_bands(const Study &study, const RingLoad &load, double omega_terminal);

/// Half-width of the error band of the terminal spin @p omega_terminal alone [rad/s]; nothing where
/// has_quick_error_bands() denies it.
std::optional<double> terminal_spin_band(const Study &study, const RingLoad &load, double omega_terminal);

} // namespace stemware::pipeline
