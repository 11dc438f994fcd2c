#pragma once

#include "fem/geometry/glass_profile.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

class NamedValues
{
public:
  /// Reads arguments name=value. Throws std::invalid_argument if @p defaults does not contain the name.
  NamedValues(int argc, char **argv, std::map<std::string, std::string> defaults)
      : values(std::move(defaults))
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const std::size_t sign = argument.find('=');
      if (sign == std::string::npos || values.count(argument.substr(0, sign)) == 0)
        throw std::invalid_argument(std::string(argv[0]) + " does not know " + argument + ".");
      values[argument.substr(0, sign)] = argument.substr(sign + 1);
    }
  }

  const std::string &text(const char *name) const { return values.at(name); }
  double number(const char *name) const { return std::stod(text(name)); }
  unsigned int count(const char *name) const { return static_cast<unsigned int>(number(name)); }
  std::vector<unsigned int> counts(const char *name) const
  {
    std::vector<unsigned int> result;
    for (const std::string &item : dealii::Utilities::split_string_list(text(name)))
      result.push_back(dealii::Utilities::string_to_int(item));
    return result;
  }

private:
  std::map<std::string, std::string> values;
};

/// Returns the default profile with the shape and crown radius [m] of @p values; crown=0: a flat land of 2
/// mm.
inline stemware::fem::GlassProfile profile_of(const NamedValues &values)
{
  stemware::fem::GlassProfile profile;
  profile.shape =
    values.text("shape") == "foot" ? stemware::fem::GlassShape::foot : stemware::fem::GlassShape::step;
  profile.crown_radius = values.number("crown");
  if (profile.crown_radius == 0)
    profile.land_width = 0.002;
  return profile;
}

/// Prints on the first rank only.
template <typename... Arguments>
void say(const char *format, const Arguments &...arguments)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  fmt::print(fmt::runtime(format), arguments...);
  std::fflush(stdout);
}

inline double peak_bytes()
{
  dealii::Utilities::System::MemoryStats memory;
  dealii::Utilities::System::get_memory_stats(memory);
  return 1024. * dealii::Utilities::MPI::sum(static_cast<double>(memory.VmHWM), MPI_COMM_WORLD);
}

/// Starts MPI and calls @p run. Prints an exception of @p run and returns 1; returns 0 otherwise.
inline int run_benchmark(int argc, char **argv, const std::function<void()> &run)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
  {
    run();
    return 0;
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
