#pragma once

#include "fem/pipeline/variants/refinement_axis.h"

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

} // namespace stemware::pipeline
