// Command-line program that tests the page's solver. Assigns each argument, e.g. "Motion/Mass=0.25", to the
// default study. Prints the answer or the error as JSON.
#include "fem/pipeline/page/explore_api.h"
#include "fem/pipeline/page/explore_page.h"
#include "fem/pipeline/page/explorer.h"
#include "fem/revolution/compliance_cache.h"

#include <cstdio>
#include <string>

int main(int n_arguments, char **arguments)
{
  using namespace stemware;
  fem::ComplianceCache cache;
  const auto [foot, disc] = pipeline::live_bodies(pipeline::Study(), cache);
  explore_begin();
  explore_take(pipeline::serialized(foot).data(), 0);
  if (disc)
    explore_take(pipeline::serialized(*disc).data(), 1);
  explore_ready(1);
  for (int i = 1; i < n_arguments; ++i)
  {
    const std::string entry = arguments[i];
    const std::size_t end = entry.find('=');
    const std::string reply = explore_set(entry.substr(0, end).c_str(), entry.substr(end + 1).c_str());
    if (reply != "{}")
    {
      std::puts(reply.c_str());
      return 1;
    }
  }
  std::puts(explore_solve(0, 1));
}
