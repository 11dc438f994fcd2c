#include "fem/pipeline/base/memory_left.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Memory that this process may still take.
struct MemoryLeft
{
  double bytes;                  ///< bytes left; infinite without a limit
  std::string limit;             ///< tightest limit with its size: "ulimit -v (0.5 GB)"
  bool is_address_space = false; ///< the limit is RLIMIT_AS
};

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the first number in a system file [bytes]; @p otherwise if the file is missing or contains a word
/// ("max").
double number_in(const fs::path &file, double otherwise)
{
  double number = 0;
  std::ifstream stream(file);
  return stream >> number ? number : otherwise;
}

/// Returns the memory of the file cache in a control group [bytes], which the system can reclaim.
double cached(const fs::path &group)
{
  std::ifstream stream(group / "memory.stat");
  std::string key;
  for (double value = 0; stream >> key >> value;)
    if (key == "inactive_file" || key == "total_inactive_file")
      return value;
  return 0;
}

void take_smaller(MemoryLeft &least, double limit, double used, const std::string &name,
                  bool is_address_space)
{
  if (limit - used < least.bytes)
    least = { limit - used, fmt::format(FMT_STRING("{} ({:.2g} GB)"), name, limit / 1e9), is_address_space };
}

/// Lowers @p least to the memory left in a control group and its parents. @p path is /a/b from the line
/// "0::/a/b" of /proc/self/cgroup. In a container, only the root group may be visible.
void take_groups(MemoryLeft &least, const fs::path &root, const fs::path &path, const std::string &limit,
                 const std::string &usage)
{
  for (fs::path group = path.relative_path();; group = group.parent_path())
  {
    const fs::path folder = root / group;
    take_smaller(least, number_in(folder / limit, infinity), number_in(folder / usage, 0) - cached(folder),
                 "the memory limit of the container or job", false);
    if (group.empty())
      return;
  }
}

MemoryLeft memory_left()
{
  MemoryLeft least = { infinity, "" };
  rlimit space = {};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
  {
    const double pages = number_in("/proc/self/statm", 0);
    take_smaller(least, static_cast<double>(space.rlim_cur),
                 pages * static_cast<double>(::sysconf(_SC_PAGESIZE)), "ulimit -v", true);
  }
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
    if (line.rfind("0::", 0) == 0)
      take_groups(least, "/sys/fs/cgroup", line.substr(3), "memory.max", "memory.current");
    else if (const auto name = line.find(":memory:"); name != line.npos)
      take_groups(least, "/sys/fs/cgroup/memory", line.substr(name + 8), "memory.limit_in_bytes",
                  "memory.usage_in_bytes");
  return least;
}

} // namespace

void require_memory_left(double needed, double reserved)
{
  const auto [bytes, limit, is_address_space] = memory_left();
  const double wanted = is_address_space ? reserved : needed;
  if (bytes < wanted)
    throw std::runtime_error(fmt::format(
      FMT_STRING("The study needs about {:.2g} GB more memory, but {} leaves {:.2g} GB; raise the "
                 "limit, or use fewer cells or threads (--threads 1)."),
      wanted / 1e9, limit, std::max(bytes, 0.) / 1e9));
}

} // namespace stemware::pipeline
