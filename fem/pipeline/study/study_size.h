#pragma once

#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// Memory of the program and its libraries, a part of StudySize::memory [byte].
inline constexpr double memory_of_the_program = 1.6e8;

/// Cost of a study, estimated to a factor of two or three from its entries and the nodes of a mesh file.
struct StudySize
{
  double unknowns = 0;                   ///< unknowns of the largest linear system
  double memory = memory_of_the_program; ///< [byte]
};

StudySize size_of(const Study &study);

/// Throws BadInput that names the costliest entry if @p study exceeds Contact/Memory limit or Motion/Step
/// limit.
void require_affordable(const Study &study);

} // namespace stemware::pipeline
