#include "fem/pipeline/base/json.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

TEST(JsonText, EscapesMarkupAndParsesToTheSameValues)
{
  const nlohmann::ordered_json json = { { "</SCRIPT><!--<script>", "\u2028 \u2029 & \\ \\u003c \"<b>\"" },
                                        { "number", 1.5 },
                                        { "list", { "<", ">" } } };
  const std::string text = json_within_html(json);
  for (const char *mark : { "<", ">", "&", "\u2028", "\u2029" })
    EXPECT_THAT(text, testing::Not(testing::HasSubstr(mark)));
  EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
}

} // namespace
} // namespace stemware::pipeline
