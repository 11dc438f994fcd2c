#pragma once

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Throws BadInput with the words of today for an entry of version 0.1 that has another name now, and for a
/// value of it that has; does nothing for all others. @p origin begins the sentence: where the entry comes
/// from; @p path is Section/Entry; @p value is the text that it is given, nothing where the entry alone is
/// asked for.
void refuse_renamed(const std::string &origin, const std::string &path,
                    const std::optional<std::string> &value = {});

} // namespace stemware::pipeline
