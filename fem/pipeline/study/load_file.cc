#include "fem/pipeline/study/load_file.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// The torque of all of them takes seconds; its kernels have fallen to nothing long before.
constexpr std::size_t most_harmonics = 1000;

/// Content of a load file as far as it has been read.
struct Coefficients
{
  std::vector<double> a;
  std::vector<double> b;
  std::optional<double> radius;
};

/// Larger loads and rings are slips of units, and overflow.
constexpr double largest_number = 1e12;

/// How much larger than a_0 a coefficient may be: a load that pulls nowhere has none above 2.
constexpr double largest_share = 1000;

void read_comment(const std::string &where, const std::string &line, Coefficients &coefficients)
{
  const std::string key = "# ring radius:";
  const std::string unit = "(m)";
  const auto end = line.rfind(unit);
  if (line.compare(0, key.size(), key) != 0 || end == std::string::npos)
    return;
  require(!coefficients.radius, where + "the ring radius is given a second time; leave one of them.");
  coefficients.radius = parse_number(line.substr(key.size(), end - key.size()));
  require(coefficients.radius && *coefficients.radius > 0 && *coefficients.radius < largest_number,
          where + "\"" + shortened(line) + "\" gives no radius; write \"# ring radius: 0.03 (m)\".");
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
  const std::string setting = "Load/File = " + shortened_path(file);
  Coefficients coefficients;
  for (const TextLine &line : read_lines(setting, file))
  {
    const std::string where = setting + ", line " + std::to_string(line.number) + ": ";
    if (line.text.front() == '#')
    {
      read_comment(where, line.text, coefficients);
      continue;
    }
    require(coefficients.a.size() <= most_harmonics,
            setting + " holds more than the " + std::to_string(most_harmonics) +
              " harmonics that a torque is computed from; leave the higher ones out.");
    require(read_row(line.text, coefficients),
            where + "expected \"" + std::to_string(coefficients.a.size()) +
              " a b\" with finite numbers in N/rad" +
              (coefficients.a.empty() ? ", a greater than 0 and b = 0." : "."));
    const double size = std::max(std::abs(coefficients.a.back()), std::abs(coefficients.b.back()));
    require(size <= std::min(largest_number, largest_share * coefficients.a.front()),
            where + "a coefficient of " + to_short_text(size) +
              " N/rad beside a_0 = " + to_short_text(coefficients.a.front()) +
              " N/rad is no load of a table; give all in N/rad, none larger than 1000 a_0 and 1e12.");
  }
  require(coefficients.radius.has_value(),
          setting + " does not say how large the ring is; add a line \"# ring radius: 0.03 (m)\".");
  require(coefficients.a.size() >= 2,
          setting + " holds no first harmonic; give at least the rows \"0 a b\" and \"1 a b\".");
  return { coefficients.a, coefficients.b, *coefficients.radius };
}

void attach_load(Study &study)
{
  study.load.from_file.reset();
  if (study.load.source == LoadSource::file)
    study.load.from_file = std::make_shared<const ring::RingStack>(read_load_file(study.load.file));
}

} // namespace stemware::pipeline
