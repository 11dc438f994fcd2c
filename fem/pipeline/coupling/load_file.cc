#include "fem/pipeline/coupling/load_file.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <fstream>
#include <optional>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// The torque of all of them takes seconds; its kernels have fallen to nothing long before.
constexpr std::size_t most_harmonics = 1000;

/// What has been read so far.
struct Coefficients
{
  std::vector<double> a;
  std::vector<double> b;
  std::optional<double> radius;
};

void read_comment(const std::string &line, Coefficients &coefficients)
{
  const std::string key = "# ring radius:";
  const std::string unit = "(m)";
  const auto end = line.rfind(unit);
  if (line.compare(0, key.size(), key) == 0 && end != std::string::npos)
    coefficients.radius = parse_number(line.substr(key.size(), end - key.size()));
}

/// Whether the line is the next row.
bool read_row(const std::string &line, Coefficients &coefficients)
{
  std::istringstream words(line);
  std::string n_text, a_text, b_text;
  words >> n_text >> a_text >> b_text;
  const auto n = parse_count(n_text);
  const auto a = parse_number(a_text);
  const auto b = parse_number(b_text);
  if (!n || !a || !b || *n != coefficients.a.size() || (*n == 0 && (*a <= 0 || *b != 0)))
    return false;
  coefficients.a.push_back(*a);
  coefficients.b.push_back(*b);
  return true;
}

} // namespace

ring::RingStack read_load_file(const std::string &file)
{
  std::ifstream stream(file);
  if (!stream)
    throw BadInput("The load file " + shortened_path(file) +
                   " cannot be read; check its path and permissions.");
  Coefficients coefficients;
  std::string line;
  for (unsigned int number = 1; std::getline(stream, line); ++number)
  {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos)
      continue;
    if (line[begin] == '#')
      read_comment(line.substr(begin), coefficients);
    else if (coefficients.a.size() > most_harmonics)
      throw BadInput("The load file " + shortened_path(file) + " holds more than the " +
                     std::to_string(most_harmonics) +
                     " harmonics that a torque is computed from; leave the higher ones out.");
    else if (!read_row(line, coefficients))
      throw BadInput(shortened_path(file) + ", line " + std::to_string(number) + ": expected \"" +
                     std::to_string(coefficients.a.size()) + " a b\" with finite numbers in N/rad" +
                     (coefficients.a.empty() ? ", a greater than 0 and b = 0." : "."));
  }
  if (!coefficients.radius || *coefficients.radius <= 0)
    throw BadInput("The load file " + shortened_path(file) +
                   " does not say how large the ring is; add a line \"# ring radius: 0.03 (m)\".");
  if (coefficients.a.size() < 2)
    throw BadInput("The load file " + shortened_path(file) +
                   " holds no first harmonic; give at least the rows \"0 a b\" and \"1 a b\".");
  return { coefficients.a, coefficients.b, *coefficients.radius };
}

} // namespace stemware::pipeline
