#pragma once

#include "fem/pipeline/study/table_file.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/orbit_speed_table.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A column of a file of numbers.
struct FileColumn
{
  std::vector<std::string> names; ///< what a header may call it; messages use the first
  std::string unit;               ///< of SI
};

/// Row of a file: one number for each column, in SI units.
struct FileRow
{
  std::vector<double> values;
  unsigned int line = 0; ///< where it stands in the file, counted from 1
};

/// Reads the table in @p file as parse_table() does. Throws BadInput, which begins with @p setting
/// ("--cases my.csv"), also for a file that cannot be read (read_input_text()).
TextTable read_table(const std::string &setting, const std::string &file, bool blanks_separate = false);

/// Reads a file of numbers: a table (read_table(), blanks may separate its cells) with a row for each
/// measurement. A first row such as "r (mm), z (mm)" names the columns in their order, each with its unit
/// unless that is the unit of SI. Throws BadInput with one sentence, which begins with @p setting
/// ("Glass/Profile file = my.csv") and names line and column.
std::vector<FileRow> read_column_file(const std::string &setting, const std::string &file,
                                      const std::vector<FileColumn> &columns);

/// A spin that was measured.
struct MeasuredSpin
{
  double time = 0;  ///< since the glass was at rest [s]
  double omega = 0; ///< counter-clockwise > 0 [rad/s]
};

/// The points of Motion/Measured spin file, two columns, time and spin (read_column_file()), in any order.
/// Throws BadInput that names the line.
std::vector<MeasuredSpin> read_measured_spin_file(const std::string &file);

/// The orbit speed v(t) of a hand that is no motor, from Motion/Orbit speed file, two columns, time and speed
/// (read_column_file()): times increasing, speeds greater than 0. Throws BadInput that names the line.
ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file);

/// Reads lambda(theta) from Load/File, a table of Fourier coefficients:
///
///   # ring radius: 0.03 (m)
///   0  0.4684   0
///   1  0       -0.13
///
/// i.e. rows n a_n b_n [N/rad] for n = 0, 1, 2, ... without gaps; further columns and other lines that start
/// with # are ignored, so that the harmonics.dat of a results folder can be read. Throws BadInput with one
/// sentence that names the line.
ring::RingStack read_load_file(const std::string &file);

} // namespace stemware::pipeline
