#pragma once

#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// Size of a study's computation, estimated from the entries and from the number of vertices that the mesh
/// file states, before anything is made. Measured factors, good to two or three.
struct StudySize
{
  double cells = 0;    ///< of the mesh, of a file at most; 0 without a contact
  double unknowns = 0; ///< of the largest linear system
  double memory = 0;   ///< [byte]
  double steps = 0;    ///< of the spin-up
};

/// FootResolution::edge_halvings of a solid foot: fem::edge_halvings_for() where the mesh is generated, but
/// no more than 2 where a goal halves further cells itself and estimates what each mesh leaves.
unsigned int edge_halvings(const Study &study);

StudySize size_of(const Study &study);

/// Throws BadInput, with the entry that asks for most, where the estimate is above Contact/Memory limit or
/// Motion/Step limit.
void require_affordable(const Study &study);

} // namespace stemware::pipeline
