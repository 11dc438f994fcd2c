// Links the portable libraries only, to detect missing symbols.
#include "fem/pipeline/page/explore_api.h"

#include <string>

int main()
{
  explore_begin();
  return explore_set("Load/Source", "first harmonic") == std::string("{}") ? 0 : 1;
}
