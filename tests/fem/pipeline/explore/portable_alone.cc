// The portable libraries by themselves: whatever they call is part of them.
#include "fem/pipeline/explore/explore_api.h"

#include <string>

int main()
{
  explore_begin();
  const bool knows_entries = std::string(explore_entries()).find("Motion/Mass") != std::string::npos;
  explore_set("Load/Source", "first harmonic");
  return knows_entries ? 0 : 1;
}
