// The portable libraries by themselves: whatever they call is part of them.
#include "fem/pipeline/page/explore_api.h"

#include <string>

int main()
{
  explore_begin();
  return explore_set("Load/Source", "first harmonic") == std::string("{}") ? 0 : 1;
}
