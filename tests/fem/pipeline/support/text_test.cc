#include "fem/pipeline/support/text.h"

#include <gtest/gtest.h>

#include <sstream>

namespace stemware::pipeline
{

TEST(Text, TableAlignsNumbersRightAndWordsLeft)
{
  EXPECT_EQ(text_table({ { "load", { "ring", "elastic foot" }, true },
                         { "terminal spin\n(rad/s)", { "-3.1", "no spin" } } }),
            "                terminal spin\n"
            "  load                (rad/s)\n"
            "  ring                   -3.1\n"
            "  elastic foot        no spin\n");
}

TEST(Text, TableCountsLettersNotBytes)
{
  EXPECT_EQ(text_table({ { "τ", { "1" } }, { "ω", { "10" } } }), "  τ   ω\n  1  10\n");
}

TEST(Text, TooManyColumnsFollowBelowBesideTheFirst)
{
  const std::string wide(40, '7');
  const std::string table =
    text_table({ { "n", { "1" } }, { "a", { wide } }, { "b", { wide } }, { "c", { wide } } });
  std::istringstream lines(table);
  std::vector<std::string> starts;
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_LE(line.size(), console_width);
    starts.push_back(line.substr(0, 3));
  }
  EXPECT_EQ(starts, (std::vector<std::string>{ "  n", "  1", "", "  n", "  1" }));
  EXPECT_EQ(std::count(table.begin(), table.end(), '7'), 120);
}

TEST(Text, WrapsAtTheConsolesWidth)
{
  const std::string word(49, 'x');
  EXPECT_EQ(wrapped(word + " " + word + "x  y"), word + " " + word + "x\ny"); // exactly 100 columns
  EXPECT_EQ(wrapped(word + " " + word + "xx"), word + "\n" + word + "xx");
  EXPECT_EQ(wrapped(word + " " + word, "Remark  "), "Remark  " + word + "\n        " + word);
  EXPECT_EQ(wrapped(""), "");
}

} // namespace stemware::pipeline
