#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/app/console_progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

namespace stemware::pipeline
{
namespace
{

/// Redirects standard output to the string `text` during its lifetime.
class CapturedOutput
{
public:
  CapturedOutput()
      : before(std::cout.rdbuf(text.rdbuf()))
  {
  }
  ~CapturedOutput() { std::cout.rdbuf(before); }
  CapturedOutput(const CapturedOutput &) = delete;
  CapturedOutput &operator=(const CapturedOutput &) = delete;

  std::ostringstream text;

private:
  std::streambuf *const before;
};

TEST(ConsoleProgress, CountsTorqueEvaluationsOfALongMotion)
{
  const CapturedOutput output;
  ConsoleProgress progress;
  const ring::TimeObserver observer = motion_observer(progress);
  std::size_t n_torques = 0;
  for (; output.text.str().empty(); ++n_torques)
  {
    observer(0.25);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::istringstream lines(output.text.str());
  std::string line;
  ASSERT_TRUE(std::getline(lines, line)) << output.text.str();
  std::istringstream words(line);
  std::size_t n_printed = 0;
  ASSERT_TRUE(words >> n_printed) << line;
  EXPECT_EQ(n_printed, n_torques);
  EXPECT_NE(line.find("0.25 s"), std::string::npos) << line;
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

} // namespace
} // namespace stemware::pipeline
