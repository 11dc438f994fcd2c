#pragma once

#include "fem/pipeline/study/study.h"
#include "ring_model/load/ring_stack.h"

#include <string>

namespace stemware::pipeline
{

/// Reads lambda(theta) from a table of Fourier coefficients:
///
///   # ring radius: 0.03 (m)
///   0  0.4684   0
///   1  0       -0.13
///
/// i.e. rows n a_n b_n [N/rad] for n = 0, 1, 2, ... without gaps; further columns and other lines that start
/// with # are ignored, so that the harmonics.dat of a results folder can be read. Throws BadInput with one
/// sentence that names the line.
ring::RingStack read_load_file(const std::string &file);

/// Gives a study whose load comes from a file the load of that file, LoadSection::from_file. Throws as
/// read_load_file().
void attach_load(Study &study);

} // namespace stemware::pipeline
