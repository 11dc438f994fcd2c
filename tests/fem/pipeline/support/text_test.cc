#include "fem/pipeline/support/failures.h"
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

TEST(Text, CsvQuotesWhatNeedsIt)
{
  EXPECT_EQ(csv_record({ "a", "b, c", "say \"d\"", "two\nlines", "" }),
            "a,\"b, c\",\"say \"\"d\"\"\",\"two\nlines\",\r\n");
  EXPECT_EQ(column_title("spin", "rad/s"), "spin (rad/s)");
  EXPECT_EQ(column_title("outcome", ""), "outcome");
}

TEST(Text, LikeliestWordIsTheClosest)
{
  const std::vector<std::string> words = { "run", "truncate", "compare", "sweep" };
  EXPECT_EQ(likeliest("rum", words), "run");
  EXPECT_EQ(likeliest("COMPAER", words), "compare");
  EXPECT_EQ(likeliest("xyz", words), std::nullopt); // no letter of run is left
  EXPECT_EQ(likeliest("frobnicate", words), std::nullopt);
  EXPECT_EQ(likeliest(std::string(10000000, 'r'), words), std::nullopt);
}

TEST(Text, MessagesRepeatEightyCharactersAtMost)
{
  EXPECT_EQ(shortened(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shortened(std::string(81, 'x')), std::string(80, 'x') + "...");
  EXPECT_EQ(shortened(std::string(10000000, 'x')), std::string(80, 'x') + "...");
  EXPECT_EQ(shortened("two\r\nlines"), "two lines");
  std::string accents;
  for (unsigned int i = 0; i < 81; ++i)
    accents += "é";
  EXPECT_EQ(shortened(accents), accents.substr(0, 160) + "...");
  EXPECT_EQ(shortened_path(std::string(255, 'x')), std::string(255, 'x'));
}

} // namespace stemware::pipeline
