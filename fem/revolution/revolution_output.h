#pragma once

#include "fem/contact/foot.h"
#include "fem/revolution/meridian_field.h"

#include <string>

namespace stemware::fem
{

/// Returns the foot as a VTU file, meridional cells swept round the axis: `displacement` [m] in the slip
/// frame with the table at rest (the table motion (q0, q1, q2) is transferred to the glass; azimuths of
/// the field start at @p axis), `stress` [Pa], `strain`, `von_mises_stress` [Pa], `contact_pressure` [Pa].
/// Stress and strain at shared nodes are means over the cells. Contact cells are divided along r until the
/// interpolated pressure integrates to N within 0.5 %. @p law must be local. @p gap: gap of @p body in the
/// orientation of @p solution.
std::string revolution_fields(const MeridianField &field, const BodyOfRevolution &body, const TableLaw &law,
                              const ContactSolution &solution, const BodyOfRevolution::Gap &gap, double axis);

/// Returns the section through the axis at @p azimuth (in the axes of the field) and opposite to it.
std::vector<StressedPatch> revolution_section(const MeridianField &field, double azimuth);

} // namespace stemware::fem
