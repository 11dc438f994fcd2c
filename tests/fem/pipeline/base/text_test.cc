#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/text.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{

TEST(Text, WrapsLinesAt100Columns)
{
  const std::string word(49, 'x');
  // The first line has exactly 100 columns.
  EXPECT_EQ(wrapped(word + " " + word + "x  y"), word + " " + word + "x\ny");
  EXPECT_EQ(wrapped(word + " " + word + "xx"), word + "\n" + word + "xx");
  EXPECT_EQ(wrapped(word + " " + word, "Remark  "), "Remark  " + word + "\n        " + word);
  EXPECT_EQ(wrapped(""), "");
}

TEST(Text, ClosestMatchToleratesTypingErrorsButNotOtherWords)
{
  const std::vector<std::string> words = { "run", "truncate", "converge", "sweep" };
  EXPECT_EQ(closest_match("rum", words), "run");
  EXPECT_EQ(closest_match("CONVEGRE", words), "converge");
  EXPECT_EQ(closest_match("xyz", words), std::nullopt); // "xyz" differs from "run" in every letter
  EXPECT_EQ(closest_match("frobnicate", words), std::nullopt);
  EXPECT_EQ(closest_match(std::string(10000000, 'r'), words), std::nullopt);
}

TEST(Text, ShortensTextsToEightyCharactersAndKeepsTheEndOfPaths)
{
  EXPECT_EQ(shortened(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shortened(std::string(81, 'x')), std::string(80, 'x') + "...");
  EXPECT_EQ(shortened(std::string(10000000, 'x')), std::string(80, 'x') + "...");
  EXPECT_EQ(shortened("two\r\nlines"), "two lines");
  std::string accents;
  for (unsigned int i = 0; i < 81; ++i)
    accents += "é";
  EXPECT_EQ(shortened(accents), accents.substr(0, 160) + "...");
  EXPECT_EQ(shortened_path(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shortened_path(std::string(255, 'x') + "/the/end.prm"),
            "..." + std::string(65, 'x') + "/the/end.prm");
}

} // namespace stemware::pipeline
