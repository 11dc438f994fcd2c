#include "fem/pipeline/study/renamed_entries.h"

#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// An entry of version 0.1, or a value of one, and what to do instead.
struct Renamed
{
  std::string path;
  std::string value; ///< empty: every other one, and the entry itself
  std::string instead;
};

const std::vector<Renamed> all_renamed = {
  { "Table/Kind", "rigid", "write Table/Interface = hard, Table/Substrate = rigid" },
  { "Table/Kind", "mat", "write Table/Interface = Winkler, Table/Substrate = rigid" },
  { "Table/Kind", "rough", "write Table/Interface = rough, Table/Substrate = rigid" },
  { "Table/Kind", "elastic", "write Table/Interface = hard, Table/Substrate = elastic" },
  { "Table/Kind", "",
    "write Table/Interface = hard, Winkler or rough, and Table/Substrate = rigid or elastic" },
  { "Contact/Friction coupling", "automatic", "write Contact/Friction coupling = elastic" },
  { "Load/Coupling", "frozen", "write Load/Coupling = one-way" },
  { "Load/Coupling", "response", "write Load/Coupling = two-way" },
  { "Load/Coupling", "exact", "write Load/Coupling = two-way" },
  { "Load/Response tolerance", "",
    "leave it out: with Load/Coupling = two-way the contact is solved in balance at every spin" },
};

} // namespace

void refuse_renamed(const std::string &origin, const std::string &path,
                    const std::optional<std::string> &value)
{
  const auto is_gone = [&](const Renamed &renamed) { return renamed.path == path && renamed.value.empty(); };
  const bool entry_is_gone = std::any_of(all_renamed.begin(), all_renamed.end(), is_gone);
  for (const Renamed &renamed : all_renamed)
    if (renamed.path == path && (renamed.value.empty() || renamed.value == value))
      throw BadInput(fmt::format(FMT_STRING("{}{}{} is {} of version 0.1; {}."), origin, path,
                                 value ? " = " + shortened(*value) : "",
                                 entry_is_gone ? "an entry" : "a value", renamed.instead));
}

} // namespace stemware::pipeline
