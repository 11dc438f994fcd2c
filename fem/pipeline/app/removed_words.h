#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Verb or option of an earlier version that is no longer understood.
struct RemovedWord
{
  std::string
    verb; ///< verb that the option belonged to, empty for a verb itself and for options of all verbs
  std::string word;    ///< as typed: "compare", "--random"
  std::string instead; ///< the new way, a clause without a full stop that follows "; "
};

/// Verbs and options that version 0.4 removed. The table of removed entries is in study/study_entries.cc.
const std::vector<RemovedWord> &removed_words();

/// Returns the refusal of a removed word, up to its last clause and without a full stop, or an empty string
/// if @p word was never one of this program. @p verb is the verb on the command line, empty if @p word stands
/// in its place. An option may have its value attached ("--random=...").
std::string removed_word_message(const std::string &verb, const std::string &word);

} // namespace stemware::pipeline
