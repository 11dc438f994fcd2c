#include "fem/pipeline/study/flatness.h"

#include "fem/pipeline/support/failures.h"

namespace stemware::pipeline
{

void require_flat(const Study &study, const std::string &verb)
{
  const auto check = [&](const std::string &entry, const Waviness &waviness)
  {
    if (!waviness.empty())
      throw BadInput(
        entry + " makes the load depend on the yaw angle, which stemware " + verb +
        " does not follow; leave it empty, or see the truncations and closures of stemware run.");
  };
  check("Glass/Rim waviness", study.glass.waviness);
  check("Table/Waviness", study.table.waviness);
}

} // namespace stemware::pipeline
