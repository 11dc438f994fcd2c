// The solver of the page on the command line, for tests: on the feet of the default study each argument, such
// as "Motion/Mass=0.25", is set as the page sets it. Prints the answer of the page, or its error. "fit" and a
// file before them, and entries in the place of a study: fits the entries to the run, "start=0.1 s" with a
// start that is known.
#include "fem/meridian/compliance_cache.h"
#include "fem/pipeline/explore/explore_api.h"
#include "fem/pipeline/explore/explorer.h"
#include "fem/pipeline/page/live_bodies.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

int main(int n_arguments, char **arguments)
{
  using namespace stemware;
  fem::ComplianceCache cache;
  const pipeline::LiveBodies bodies = pipeline::live_bodies(pipeline::Study(), cache);
  explore_begin();
  explore_take(pipeline::serialized(bodies.foot).data(), 0);
  explore_ready(1);
  const bool is_fit = n_arguments > 2 && arguments[1] == std::string("fit");
  std::string free, start;
  for (int i = is_fit ? 3 : 1; i < n_arguments; ++i)
  {
    const std::string entry = arguments[i];
    if (is_fit && entry.rfind("start=", 0) == 0)
    {
      start = entry.substr(6);
      continue;
    }
    const std::size_t end = entry.find('=');
    if (end == std::string::npos)
    {
      free += entry + '\n';
      continue;
    }
    const std::string reply = explore_set(entry.substr(0, end).c_str(), entry.substr(end + 1).c_str());
    if (reply != "{}")
    {
      std::puts(reply.c_str());
      return 1;
    }
  }
  if (is_fit)
  {
    std::ifstream file(arguments[2]);
    const std::string table(std::istreambuf_iterator<char>(file), {});
    std::puts(explore_fit(arguments[2], table.c_str(), free.c_str(), start.c_str()));
    return 0;
  }
  std::puts(explore_solve(0, 1));
}
