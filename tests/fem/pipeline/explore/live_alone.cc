// The live cut by itself: whatever it calls is part of it.
#include "fem/pipeline/explore/explore_api.h"

#include <string>

int main()
{
  explore_begin();
  const bool knows_entries = std::string(explore_entries()).find("Motion/Mass") != std::string::npos;
  explore_set("Load/Source", "first harmonic");
  return knows_entries ? 0 : 1;
}
