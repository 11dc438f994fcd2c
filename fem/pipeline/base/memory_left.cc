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

/// Throws std::runtime_error if @p limit, of which @p used are used, leaves less than @p needed [bytes].
void require_left(double needed, double limit, double used, const std::string &name)
{
  if (limit - used < needed)
    throw std::runtime_error(fmt::format(
      FMT_STRING("The study needs about {:.2g} GB more memory, but {} ({:.2g} GB) leaves {:.2g} GB; raise "
                 "the limit, or use fewer cells or threads (--threads 1)."),
      needed / 1e9, name, limit / 1e9, std::max(limit - used, 0.) / 1e9));
}

/// Calls require_left() for a control group and its parents. @p path is /a/b from the line "0::/a/b" of
/// /proc/self/cgroup. In a container, only the root group may be visible.
void require_left_in_groups(double needed, const fs::path &root, const fs::path &path,
                            const std::string &limit, const std::string &usage)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (fs::path group = path.relative_path();; group = group.parent_path())
  {
    const fs::path folder = root / group;
    require_left(needed, number_in(folder / limit, infinity), number_in(folder / usage, 0) - cached(folder),
                 "the memory limit of the container or job");
    if (group.empty())
      return;
  }
}

} // namespace

void require_memory_left(double needed, double reserved)
{
  rlimit space = {};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
  {
    const double pages = number_in("/proc/self/statm", 0);
    require_left(reserved, static_cast<double>(space.rlim_cur),
                 pages * static_cast<double>(::sysconf(_SC_PAGESIZE)), "ulimit -v");
  }
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
    if (line.rfind("0::", 0) == 0)
      require_left_in_groups(needed, "/sys/fs/cgroup", line.substr(3), "memory.max", "memory.current");
    else if (const auto name = line.find(":memory:"); name != line.npos)
      require_left_in_groups(needed, "/sys/fs/cgroup/memory", line.substr(name + 8), "memory.limit_in_bytes",
                             "memory.usage_in_bytes");
}

} // namespace stemware::pipeline
