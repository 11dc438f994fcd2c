#pragma once

#include "fem/revolution/meridian_field.h"
#include "fem/revolution/pressure_field.h"

#include <Eigen/Core>

#include <iosfwd>

namespace stemware::fem
{

/// How the x axis and the table of a contact solution stand in the slip frame.
struct FootPose
{
  Eigen::Vector3d motion = Eigen::Vector3d::Zero(); ///< q0, q1, q2 of the table, put back on the glass
  double direction = 0;                             ///< azimuth of the solution's x axis [rad]
};

/// Writes the foot as a VTU file: the meridional cells swept round the axis in sectors, cells of the
/// elements' degree, with what SolidBody::write_fields gives: `displacement` [m] in the slip frame with the
/// table at rest, `stress` [Pa], `contact_pressure` [Pa] on the contact zone.
///
/// Contact cells wider than the contact are cut along r until the drawn pressure carries N to half
/// a per cent.
void write_revolution_fields(const MeridianField &field, const PressureField &pressure, const FootPose &pose,
                             std::ostream &file);

} // namespace stemware::fem
