#include "tests/fem/pipeline/browser.h"

namespace stemware::test
{

std::string script_string(const std::string &text)
{
  std::string quoted = nlohmann::json(text).dump();
  for (auto at = quoted.find("</"); at != std::string::npos; at = quoted.find("</", at + 3))
    quoted.insert(at + 1, "\\");
  return quoted;
}

std::string axe_script()
{
  const std::string axe = std::string(STEMWARE_AXE).empty() ? "" : read_text(STEMWARE_AXE);
  return "const axe_source = " + script_string(axe) + R"(;
const serious = page => {
  if (!axe_source)
    return Promise.resolve([]);
  page.eval(axe_source);
  return page.axe.run().then(
    found => found.violations.filter(one => one.impact == "serious" || one.impact == "critical")
               .map(one => one.id + ": " + one.nodes.map(node => node.html.slice(0, 120)).join(" | ")),
    error => ["axe-core does not run: " + error]);
};
)";
}

Ended chromium(const ScratchFolder &scratch, const std::vector<std::string> &arguments)
{
  std::vector<std::string> command = { STEMWARE_CHROMIUM,
                                       "--headless",
                                       "--no-sandbox",
                                       "--disable-gpu",
                                       "--disable-dev-shm-usage",
                                       "--no-first-run",
                                       "--hide-scrollbars",
                                       "--disable-extensions",
                                       "--disable-background-networking",
                                       "--user-data-dir=" + (scratch / "profile").string(),
                                       "--enable-logging=stderr",
                                       "--window-size=1300,1000" };
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunningProgram(command, scratch.path()).end();
}

} // namespace stemware::test
