#pragma once

#include "fem/solid/solid_body.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>

namespace stemware::fem
{

/// The contact zone of a hexahedral mesh: its surface, and which dofs its nodes are.
struct SolidContactZone
{
  ContactSurface surface;
  std::vector<dealii::types::global_dof_index> node_dofs; ///< vertical displacement of each contact node
  double smallest_cell = 0;                               ///< shortest edge of a contact face [m]
};

/// A contact node's horizontal displacement among the dofs.
struct HorizontalDofs
{
  unsigned int node;
  dealii::types::global_dof_index x, y;
};

/// Of those @p node_dofs, vertical and ascending, that this rank owns; the horizontal ones are its own too.
std::vector<HorizontalDofs>
owned_horizontal_dofs(const dealii::DoFHandler<3> &dof_handler,
                      const std::vector<dealii::types::global_dof_index> &node_dofs);

/// Describes the faces with FootBoundary::contact_zone of all ranks. Every face carries lines at Gauss points
/// of its more azimuthal direction; nodes that hang on others are replaced by these; the gap of a point is
/// its own z plus @p gap(x, y). Throws std::invalid_argument when there is no such face.
SolidContactZone describe_contact_zone(const dealii::Mapping<3> &mapping,
                                       const dealii::DoFHandler<3> &dof_handler,
                                       const dealii::AffineConstraints<double> &constraints,
                                       const SolidBody::Gap &gap);

} // namespace stemware::fem
