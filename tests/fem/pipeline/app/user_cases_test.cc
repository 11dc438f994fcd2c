// Inputs of the kind that users bring, in the folder user_cases: each has a refusal or numbers of another
// source.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace stemware::test
{
namespace
{

const std::string folder_of_cases = STEMWARE_MESHES "/../tests/fem/pipeline/app/user_cases/";

struct NumberOfCase
{
  std::string place; ///< in summary.json
  double right, within;
};

struct UserCase
{
  std::string study; ///< file of the folder; empty: the default study
  std::vector<std::string> settings;
  std::string refusal;                    ///< part of the message; empty: the study has an answer
  std::vector<NumberOfCase> numbers = {}; ///< without regard to sign
};

/// A study of the mesh @p file, of a solid foot.
std::vector<std::string> with_mesh(const std::string &file)
{
  return { "Table/Interface=Winkler", "Table/Substrate=rigid", "Contact/Body=solid",
           "Contact/Mesh file=" + folder_of_cases + file };
}

} // namespace

TEST(UserCases, HaveTheirRightAnswers)
{
  // A tube of few cells, whose spin does not depend on the dialect of the file.
  const NumberOfCase spin_of_tube = { "/ring/omega_terminal", 3.674484, 1e-5 };
  // Hertz under the line load of a torus on a half-space: 2 sqrt(4 q rho / (pi E*)); the annulus by the
  // equilibrium of a linear pressure.
  const std::vector<UserCase> cases = {
    { "torus.prm", { "Load/Moment ratio=0" }, "", { { "/load/contact_width", 26.90e-6, 0.14e-6 } } },
    { "torus.prm",
      {},
      "",
      { { "/load/contact_width", 28.21e-6, 0.14e-6 },
        { "/contact/table_motion/0", 3.298e-7, 1e-9 },
        { "/contact/table_motion/1", 8.525e-7, 3e-9 } } },
    { "wide_land.prm",
      {},
      "",
      { { "/load/peak_pressure", 32559, 5 }, { "/load/contact_fraction", 0.1996, 2e-4 } } },
    { "", with_mesh("plain.msh"), "", { spin_of_tube } },
    { "", with_mesh("parametric.msh"), "", { spin_of_tube } },
    { "", with_mesh("unused_node.msh"), "", { spin_of_tube } },
    { "", with_mesh("hanging.msh"), "8 nodes" },
    { "",
      []
      {
        std::vector<std::string> settings = with_mesh("names.msh");
        settings.push_back("Contact/Mesh contact id=9");
        return settings;
      }(),
      "Fu\u00df" },
  };
  const ScratchFolder scratch;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const UserCase &given = cases[i];
    std::vector<std::string> command = { "run", "--quick" };
    if (!given.study.empty())
      command.push_back(folder_of_cases + given.study);
    const std::string results = "results_" + std::to_string(i);
    if (!given.refusal.empty())
    {
      const Ended ended = stemware(scratch, with_settings(command, given.settings));
      EXPECT_EQ(ended.exit_code, 1) << i;
      EXPECT_NE(ended.err.find(given.refusal), std::string::npos) << ended.err;
      continue;
    }
    const nlohmann::json summary = solved(scratch, command, given.settings, results);
    for (const NumberOfCase &number : given.numbers)
      EXPECT_NEAR(std::abs(summary.at(nlohmann::json::json_pointer(number.place)).get<double>()),
                  number.right, number.within)
        << i << " " << number.place;
  }
}

} // namespace stemware::test
