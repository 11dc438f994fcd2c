// Verbs and options that version 0.4 removed: each is refused with the new way.
#include "fem/pipeline/app/removed_words.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::test
{
namespace
{

TEST(RemovedWords, EachIsRefusedWithTheNewWay)
{
  const ScratchFolder scratch;
  for (const pipeline::RemovedWord &removed : pipeline::removed_words())
  {
    SCOPED_TRACE(removed.verb + " " + removed.word);
    std::vector<std::string> arguments = { removed.word };
    if (removed.word.front() == '-')
      arguments = { removed.verb.empty() ? "run" : removed.verb, removed.word, "1" };
    const Ended ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_THAT(ended.err,
                testing::HasSubstr(removed.word + " was removed in version 0.4; " + removed.instead));
  }
  EXPECT_TRUE(names_in(scratch.path()).empty());
}

} // namespace
} // namespace stemware::test
