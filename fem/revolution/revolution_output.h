#pragma once

#include "fem/contact/foot.h"
#include "fem/revolution/meridian_field.h"
#include "fem/revolution/pressure_field.h"

#include <Eigen/Core>

#include <string>

namespace stemware::fem
{

/// Foot as a VTU file: the meridional cells swept round the axis in sectors, with what
/// SolidBody::write_fields gives: `displacement` [m] in the slip frame with the table at rest, its motions
/// @p motion (q0, q1, q2) put back on the glass, where the field's azimuths count from @p axis, `stress`
/// [Pa], `strain`, `von_mises_stress` [Pa], `contact_pressure` [Pa] on the contact zone. In the nodes that
/// cells share, stress and strain are the means of the cells'.
///
/// Contact cells wider than the contact are cut along r until the drawn pressure carries N to half
/// a per cent.
std::string revolution_fields(const MeridianField &field, const PressureField &pressure,
                              const Eigen::Vector3d &motion, double axis);

/// Section through the axis at @p azimuth, which counts as the field's do, and opposite to it.
std::vector<StressedPatch> revolution_section(const MeridianField &field, double azimuth);

} // namespace stemware::fem
