#include "fem/pipeline/app/removed_words.h"

namespace stemware::pipeline
{

const std::vector<RemovedWord> &removed_words()
{
  static const std::vector<RemovedWord> words = {
    { "sweep", "--random",
      "draw the cases in Python and give the table with --cases cases.csv (docs/sweep.md)" },
    { "sweep", "--samples",
      "draw the cases in Python and give the table with --cases cases.csv (docs/sweep.md)" },
    { "sweep", "--seed",
      "draw the cases in Python and give the table with --cases cases.csv (docs/sweep.md)" },
    { "sweep", "--jobs", "write --threads, as for all verbs" },
    { "sweep", "--most-cases", "a sweep has as many cases as its list, at most a million" },
    { "sweep", "--restart", "remove the folder of the results, or choose another one with --output" },
    { "", "compare",
      "the budget of `stemware run` has the steps from the paper's model to the study's, and "
      "`stemware sweep --vary \"Motion/Closure=paper,hand,full\"` the moment balances" },
    { "", "slide", "an example in Python: docs/python/slide.py" },
    { "converge", "--at", "the torque is evaluated at half and at one and a half times the terminal spin" },
    { "truncate", "--at", "torque.csv of `stemware run` has the torque over the spin" },
    { "mesh", "--output", "the console shows the whole answer, and --json prints it as one line" },
    { "", "describe", "`stemware help` and `stemware help VERB` replace the manual page" },
  };
  return words;
}

std::string removed_word_message(const std::string &verb, const std::string &word)
{
  const std::string name = word.substr(0, word.find('='));
  for (const RemovedWord &removed : removed_words())
  {
    const bool is_verb = removed.word.front() != '-';
    const bool in_place = is_verb ? verb.empty() : removed.verb.empty() || removed.verb == verb;
    if (removed.word == name && in_place)
      return name + " was removed in version 0.4; " + removed.instead;
  }
  return "";
}

} // namespace stemware::pipeline
