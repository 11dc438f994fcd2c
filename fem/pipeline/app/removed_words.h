#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Verb or option that was removed since an earlier version.
struct RemovedWord
{
  std::string
    verb; ///< verb that the option belonged to, empty for a verb itself and for options of all verbs
  std::string word;    ///< as typed: "compare", "--random"
  std::string instead; ///< replacement, a clause without a full stop that follows "; "
};

/// Verbs and options that version 0.4 removed. The table of removed entries is in study/study_entries.cc.
const std::vector<RemovedWord> &removed_words();

/// Returns the message for a removed word, without its last clause and full stop; empty if @p word was never
/// part of the program. @p verb: the verb on the command line, empty if @p word is in its place. An option
/// may have its value attached ("--random=...").
std::string removed_word_message(const std::string &verb, const std::string &word);

} // namespace stemware::pipeline
