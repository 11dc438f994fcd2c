#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_entries.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/browser.h"
#include "tests/fem/pipeline/matchers.h"

#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

const std::vector<std::pair<std::string, std::string>> moves = { { "Motion/Friction coefficient", "0.2" },
                                                                 { "Motion/Orbit speed", "0.25" },
                                                                 { "Motion/Hand height", "0.05" },
                                                                 { "Motion/Centre of mass height", "0.1" },
                                                                 { "Table/Foundation modulus", "1e11" } };

/// Returns a script that opens @p page in frames of 1100 and 400 px and sets the sliders to `moves` one by
/// one.
std::string moving_script(const std::string &page)
{
  return axe_script() + R"(
  const found = {};
  for (const width of [1100, 400]) {
    const frame = document.createElement("iframe");
    frame.style = "border:0;height:900px;width:" + width + "px";
    frame.srcdoc = )" +
         script_string(page) + R"(;
    document.body.append(frame);
    while (!frame.contentWindow.started)
      await new Promise(r => setTimeout(r, 20));
    const omega = [];
    let last;
    for (const [path, value] of )" +
         nlohmann::json(moves).dump() + R"() {
      last = await frame.contentWindow.move(path, value);
      omega.push(last.omega);
    }
    const errors = [...last.errors], { body } = frame.contentDocument;
    frame.contentWindow.Worker.prototype.postMessage = () => {}; // from now on, the solver gets no requests
    frame.contentWindow.move("Motion/Hand height", 0.14);
    await new Promise(r => setTimeout(r, 600));
    const answer = body.querySelector("#answer"), waits = body.matches(".busy") && answer.textContent;
    while (width == 1100 && !body.dataset.rested)
      await new Promise(r => setTimeout(r, 100));
    found[width] = { omega, errors, waits, late: answer.textContent, text: last.text, width: frame.contentDocument.documentElement.scrollWidth,
                     serious: await serious(frame.contentWindow) };
    frame.remove();
  }
  return found;)";
}

TEST(ExplorePage, SlidersGiveTheSpinsOfTheProgramAndAWaitingPageStatesTheTippingHeight)
{
  const ScratchFolder scratch;
  const nlohmann::json found =
    found_in_browser(scratch, moving_script(read_text(fs::path(STEMWARE_DOCS) / "explore.html")));
  pipeline::Study study;
  fem::ComplianceCache cache;
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    pipeline::assign(pipeline::study_entries(study), "", moves[i].first, moves[i].second);
    const auto foot = pipeline::study_foot(study, pipeline::foot_maker(cache));
    const double omega =
      ring::answer(pipeline::find_load(study, foot), pipeline::spin_question(study)).terminal->omega;
    for (const char *const width : { "1100", "400" })
      EXPECT_NEAR(found[width]["omega"][i].get<double>(), omega, 1e-10) << moves[i].first << ", " << width;
  }
  for (const char *const width : { "1100", "400" })
  {
    EXPECT_TRUE(found[width]["errors"].empty()) << found[width]["errors"];
    EXPECT_EQ(found[width]["serious"], nlohmann::json::array()) << found[width]["serious"].dump(1);
    EXPECT_LE(found[width]["width"].get<int>(), std::stoi(width)) << "the page has to be scrolled sideways";
    // A ring at rest tips if the moment of its load reaches weight times radius R, i.e. at the hand height h
    // with (h - 0.1 m)^2 k^2 + h^2 mu^2 = R^2: 0.15 m for mu = 0.2 and k = 0.0425 (acceleration / gravity).
    EXPECT_THAT(found[width]["waits"].get<std::string>(), testing::HasSubstr("with the hand at about 150"));
    EXPECT_THAT(found[width]["waits"].get<std::string>(), testing::HasSubstr("Solving …"));
    EXPECT_NE(found[width]["text"].get<std::string>().find("rad/s"), std::string::npos);
  }
  // The solver does not answer, so the page still shows the last balance, with the hand at 50 mm.
  const std::string late = in_one_line(found["1100"]["late"].get<std::string>());
  for (const char *const words :
       { "with the hand at about 150 mm", "rad/s with the hand at 50 mm", "use stemware run" })
    EXPECT_THAT(late, testing::HasSubstr(words));
  EXPECT_THAT(late, testing::Not(testing::HasSubstr("Solving")));
}

/// Returns a script that opens @p page and sets the first slider of `moves`; `found` has the answer.
std::string moved_page(const std::string &page)
{
  return framed(page, 1100) + R"(
  while (!frame.contentWindow?.started)
    await new Promise(r => setTimeout(r, 20));
  const shown = frame.contentWindow, root = shown.document;
  const [path, value] = )" +
         nlohmann::json(moves[0]).dump() + R"(;
  const found = await shown.move(path, value);
)";
}

/// Returns a script that opens @p page, sets the first slider of `moves` and goes through the lesson. The
/// script returns the spin, errors and texts of the lesson. "told": answer and notice for a tipping study, an
/// implausible value and a forbidden value.
std::string lesson_script(const std::string &page)
{
  return moved_page(page) + R"(
  while (!root.body.dataset.rested)
    await new Promise(r => setTimeout(r, 20));
  found.told = [];
  for (const [path, value] of [["Motion/Hand height", 0.38], ["Motion/Mass", 3], ["Motion/Orbit speed", -1]]) {
    await shown.move(path, value);
    found.told.push(root.querySelector("#answer").textContent + " " + root.querySelector("#notice").textContent);
    await shown.move(path);
  }
  root.querySelector("#lesson-button").click();
  found.lesson = [];
  for (let step = 1; step <= 5; ++step) {
    root.querySelector("#lesson [role=group] button").click();
    found.lesson.push(root.querySelector("#lesson").innerText);
    root.querySelector("#lesson .row:last-child button:last-child").click();
  }
  return found;)";
}

TEST(ExplorePage, SavedPageOpensWithTheSavedValues)
{
  const ScratchFolder scratch;
  const nlohmann::json found =
    found_in_browser(scratch, framed(read_text(fs::path(STEMWARE_DOCS) / "explore.html"), 1100) + R"(
  const wait = async until => { while (!until()) await new Promise(r => setTimeout(r, 20)); };
  await wait(() => frame.contentWindow?.started);
  const shown = frame.contentWindow;
  const moved = await shown.move("Motion/Hand height", 0.05);
  shown.document.querySelector(`#tables [data-name="mat"]`).click();
  let saved;
  shown.URL.createObjectURL = blob => ((saved = blob), "#");
  shown.document.getElementById("as-page").click();
  const text = await saved.text(); // a blob is readable only while its page is open
  frame.removeAttribute("srcdoc");
  frame.srcdoc = text;
  await wait(() => frame.contentWindow !== shown || !frame.contentWindow.started || frame.contentDocument.body.dataset.rested);
  await wait(() => frame.contentWindow?.started && frame.contentDocument.body.dataset.rested);
  const page = frame.contentDocument;
  return { hand: page.getElementById("Motion-Hand-height").value, table: page.querySelector("#tables [aria-pressed=true]").textContent };)");
  EXPECT_EQ(found["hand"], "50");
  EXPECT_EQ(found["table"], "mat");
}

/// Returns the line load at @p angle [N/m] as text, from the Fourier series @p load of a summary.
std::string line_load_text(const nlohmann::json &load, double angle)
{
  double value = 0;
  for (std::size_t n = 0; n < load["a"].size(); ++n)
    value += load["a"][n].get<double>() * std::cos(static_cast<double>(n) * angle) +
             load["b"][n].get<double>() * std::sin(static_cast<double>(n) * angle);
  std::ostringstream text;
  text << std::setprecision(3) << value / load["ring_radius"].get<double>() << " N/m";
  return text.str();
}

TEST(ExplorePage, PageOfAStudySolvesTheStudyAndShowsTheLesson)
{
  const ScratchFolder scratch;
  const auto with = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), { "--set", "Motion/Mass=0.25" });
    return stemware(scratch, arguments);
  };
  const Ended made = with({ "explore", "--output", "page.html" });
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string move = moves[0].first + "=" + moves[0].second;
  ASSERT_EQ(with({ "run", "--quick", "--output", "moved", "--set", move }).exit_code, 0);
  const auto moved = read_summary(scratch / "moved");
  const double omega = moved["ring"]["omega_terminal"].get<double>();
  const std::string page = read_text(scratch / "page.html");
  EXPECT_LT(page.size(), 1'300'000u);
  const nlohmann::json found = found_in_browser(scratch, lesson_script(page));
  EXPECT_NEAR(found["omega"].get<double>(), omega, 1e-9);
  EXPECT_EQ(found["errors"], nlohmann::json::array());
  const nlohmann::json &told = found["told"];
  EXPECT_THAT(told[0].get<std::string>(), testing::HasSubstr("the glass tips"));
  EXPECT_THAT(told[1].get<std::string>(), testing::HasSubstr("is outside 0.02 to 2"));
  EXPECT_THAT(told[2].get<std::string>(),
              testing::HasSubstr("Not available in this page: Motion/Orbit speed"));
  ASSERT_EQ(found["lesson"].size(), 5u);
  const std::string pressed = boost::replace_all_copy(found["lesson"][1].get<std::string>(), "\u00a0", " ");
  for (const double angle : { ring::pi / 2, -ring::pi / 2 })
    EXPECT_THAT(pressed, testing::HasSubstr(line_load_text(moved["load"], angle))) << "at rest";
  for (const nlohmann::json &step : found["lesson"])
    EXPECT_THAT(step.get<std::string>(), testing::Not(testing::ContainsRegex("NaN|undefined|\u2013")));
  // If the content security policy forbids workers from blob:, the page solves in its main thread.
  const std::string without_worker = boost::replace_all_copy(page, "worker-src blob:", "worker-src 'none'");
  const nlohmann::json alone = found_in_browser(scratch, moved_page(without_worker) + "return found;", true);
  EXPECT_NEAR(alone["omega"].get<double>(), omega, 1e-9);
  EXPECT_EQ(alone["errors"], nlohmann::json::array());
  // A page is also written if the glass tips while it spins up.
  const Ended falls =
    stemware(scratch, with_settings({ "explore", "--output", "falls.html" },
                                    { "Motion/Centre of mass height=0.138", "Motion/Force offset=-0.05",
                                      "Contact/Azimuth lines=64", "Contact/Harmonics=8" }));
  EXPECT_EQ(falls.exit_code, 0) << falls.err;
}

struct Taught
{
  std::string name;
  /// Changed entries and their values; "table" selects a table by its button.
  std::vector<std::pair<std::string, std::string>> changes;
  std::vector<int> right; ///< correct option of each step; empty if the glass tips
  std::string words;
};

/// Returns a script that opens @p page in each of @p states and tries all options of the lesson. The script
/// returns for each state "right": accepted options of each step; "texts": text of each step; "torque": path
/// of the torque arrow; "words": texts outside the lesson; "end": text at the end of the spin-up; "troubles":
/// layout errors of the scene.
std::string states_script(const std::string &page, const std::vector<Taught> &states)
{
  nlohmann::ordered_json wanted;
  for (const Taught &state : states)
    wanted[state.name] = state.changes;
  return troubles_script() + framed(page, 1100) + R"(
  const wait = async until => { while (!until()) await new Promise(r => setTimeout(r, 20)); };
  await wait(() => frame.contentWindow?.started);
  const shown = frame.contentWindow, root = shown.document, $ = id => root.getElementById(id), found = {};
  const rests = async () => {
    delete root.body.dataset.rested;
    await wait(() => root.body.dataset.rested);
  };
  const lesson = selector => root.querySelectorAll("#lesson " + selector);
  for (const [name, changes] of Object.entries()" +
         wanted.dump() + R"()) {
    for (const [path, value] of changes)
      if (path == "table") root.querySelector(`#tables [data-name="${value}"]`).click();
      else await shown.move(path, value);
    await rests();
    const state = (found[name] = { right: [], texts: [], troubles: troubles(root).filter(trouble => trouble.startsWith("scene")) });
    const time = root.querySelector("#scene input"), instant = root.querySelector("#scene .instant");
    time.value = time.max;
    time.dispatchEvent(new shown.Event("input"));
    state.end = instant.textContent;
    time.value = 0;
    time.dispatchEvent(new shown.Event("input"));
    state.torque = root.querySelector("#scene svg path:last-of-type").getAttribute("d");
    state.words = instant.textContent + " " + $("facts").innerText + " " + $("answer").innerText;
    $("lesson-button").click();
    for (let step = 1; step <= 5; ++step) {
      const right = [];
      for (let i = 2; i >= 0; --i) {
        lesson("[role=group] button")[i].click();
        if ($("lesson").innerText.includes("As you said.")) right.push(i);
      }
      state.right.push(right);
      state.texts.push($("lesson").innerText);
      lesson(".row:last-child button:last-child")[0].click();
    }
    $("lesson-button").click();
    for (const [path] of changes)
      if (path == "table") root.querySelector(`#tables [data-name="hardwood"]`).click();
      else await shown.move(path);
  }
  return found;)";
}

TEST(ExplorePage, LessonIsCorrectInThirteenStates)
{
  const std::string hand = "Motion/Hand height", centre = "Motion/Centre of mass height";
  // If the hand is below the centre of mass, the outside of the rim is loaded more. Friction on the outside
  // turns the glass against the orbit.
  const std::vector<int> below = { 0, 1, 1, 0, 1 };
  const std::vector<Taught> states = {
    { "default", {}, below, "The rigid ring of the paper" },
    { "clockwise", { { "Motion/Orbit sense", "clockwise" } }, below, "The rigid ring of the paper" },
    { "far below", { { hand, "0.01" } }, below, "one turn in" },
    { "lift-off", { { hand, "0.06" } }, { 0, 2, 1, 0, 1 }, "one turn in" },
    { "level", { { hand, "0.08" } }, { 2, 2, 1, 2, 1 }, "Here nothing starts one" },
    { "above", { { hand, "0.09" } }, { 1, 2, 1, 1, 1 }, "one turn in" },
    { "above, clockwise",
      { { hand, "0.09" }, { "Motion/Orbit sense", "clockwise" } },
      { 1, 2, 1, 1, 1 },
      "one turn in" },
    { "held", { { "Motion/Grip torque", "0.005" } }, below, "the fingers hold the glass" },
    { "falls",
      { { "table", "mat" }, { centre, "0.138" }, { hand, "0.088" } },
      { 0, 2, 1, 0, 1 },
      "This glass tips over before" },
    { "tips", { { hand, "0.38" } }, {}, "This glass tips over" },
    { "oak", { { "table", "oak" } }, below, "one turn in" },
    { "window glass", { { "table", "window glass" } }, below, "one turn in" },
    { "mat", { { "table", "mat" } }, below, "one turn in" }
  };
  const ScratchFolder scratch;
  const nlohmann::json found =
    found_in_browser(scratch, states_script(read_text(fs::path(STEMWARE_DOCS) / "explore.html"), states));
  for (const Taught &state : states)
  {
    SCOPED_TRACE(state.name);
    std::vector<std::vector<int>> right(5);
    for (std::size_t i = 0; i < state.right.size(); ++i)
      right[i] = { state.right[i] };
    EXPECT_EQ(found[state.name]["right"], nlohmann::json(right));
    EXPECT_THAT(found[state.name]["texts"][4].get<std::string>(), testing::HasSubstr(state.words));
    for (const nlohmann::json &text : found[state.name]["texts"])
      EXPECT_THAT(text.get<std::string>(),
                  testing::Not(testing::ContainsRegex("NaN|undefined|\u2013|\u207b|-0 |\u22120 ")));
    EXPECT_EQ(found[state.name]["troubles"], nlohmann::json::array())
      << found[state.name]["troubles"].dump(1);
    // The lesson and the page around the lesson show the same digits of a number.
    const auto text = [&](std::size_t step)
    { return in_one_line(found[state.name]["texts"][step].get<std::string>()); };
    const std::string beside = in_one_line(found[state.name]["words"].get<std::string>());
    std::smatch spin, torque, share;
    if (std::regex_search(beside, spin, std::regex("orbit (at \\S+ rad/s): (one turn in \\S+ s)")))
    {
      EXPECT_THAT(text(4), testing::HasSubstr(spin[1].str()));
      EXPECT_THAT(text(4), testing::HasSubstr(spin[2].str()));
    }
    if (std::regex_search(beside, torque, std::regex("torque at rest (-?[0-9.]*[1-9]\\d* mN m)")))
    {
      EXPECT_THAT(text(3), testing::HasSubstr(torque[1].str()));
    }
    // At the end of the spin-up, at most 5 % of the largest torque is left.
    const std::string end = in_one_line(found[state.name]["end"].get<std::string>());
    if (!spin.empty() && std::regex_search(end, share, std::regex("(\\d+) % of the largest torque")))
    {
      EXPECT_LE(std::stoi(share[1]), 5) << end;
    }
    // The lesson mentions the torque arrow only if the arrow is drawn.
    EXPECT_EQ(text(3).find("The arrow round the stem") != std::string::npos,
              !state.right.empty() && found[state.name]["torque"] != "");
  }
  // If the hand is at the centre of mass ("level"), rounding errors are not shown as torque or spin.
  EXPECT_EQ(found["level"]["torque"], "");
  EXPECT_NE(found["default"]["torque"], "");
  const std::string words = found["level"]["words"].get<std::string>();
  EXPECT_THAT(words, testing::HasSubstr("no torque"));
  EXPECT_THAT(words, testing::Not(testing::HasSubstr("\u22120.0")));
}

TEST(ExplorePage, LessonFitsBelowItsSceneOnAPhone)
{
  const ScratchFolder scratch;
  const nlohmann::json found = found_in_browser(
    scratch, troubles_script() + framed(read_text(fs::path(STEMWARE_DOCS) / "explore.html"), 400) + R"(
  frame.style.height = "800px";
  const wait = async until => { while (!until()) await new Promise(r => setTimeout(r, 20)); };
  await wait(() => frame.contentWindow?.started && frame.contentDocument.body.dataset.rested);
  const root = frame.contentDocument, found = [];
  root.getElementById("lesson-button").click();
  for (const height of [0.03, 0.08, 0.09]) {
    await frame.contentWindow.move("Motion/Hand height", height);
    delete root.body.dataset.rested;
    await wait(() => root.body.dataset.rested);
    for (let step = 1; step <= 5; ++step) {
      root.querySelector("#lesson [role=group] button").click();
      const [scene, text] = ["#scene svg", "#lesson"].map(part => root.querySelector(part).getBoundingClientRect());
      found.push({ top: scene.top, middle: text.top - scene.bottom, bottom: text.bottom,
                   troubles: troubles(root).filter(trouble => trouble.startsWith("scene")) });
      root.querySelector("#lesson .row:last-child button:last-child").click();
    }
    for (let step = 4; step >= 1; --step) root.querySelector("#lesson .row:last-child button").click();
  }
  return found;)");
  ASSERT_EQ(found.size(), 15u);
  for (const nlohmann::json &step : found)
  {
    EXPECT_GE(step["top"].get<double>(), 0) << step;
    EXPECT_GE(step["middle"].get<double>(), 0) << step;
    EXPECT_LE(step["bottom"].get<double>(), 800) << step;
    EXPECT_EQ(step["troubles"], nlohmann::json::array()) << step["troubles"].dump(1);
  }
}

TEST(ExplorePage, HostileTextRunsNoScript)
{
  const ScratchFolder scratch;
  const Ended made = stemware(scratch, { "explore", "--output", "page.html" });
  ASSERT_EQ(made.exit_code, 0) << made.err;
  scratch.write("bare.html", without_policy(read_text(scratch / "page.html")));

  const std::string words =
    "%3Cimg%20src=x%20onerror=%22document.documentElement.dataset.ran%3D1%22%3E%60%27%5C%E2%80%A8";
  const auto address = [](const std::string &value)
  { return "bare.html#other=" + value + "&glass=" + value + "&table=" + value + "&harmonics=" + value; };
  const std::vector<std::string> answering = { "page.html", "bare.html",
                                               address("constructor") + "&constructor=1",
                                               address("__proto__"), address(words) };
  const std::vector<std::string> refusing = { "bare.html#constructor/__proto__=1",
                                              "bare.html#__proto__/x=" + words,
                                              "bare.html#Motion/Mass=" + words };
  std::vector<std::string> all = answering;
  all.insert(all.end(), refusing.begin(), refusing.end());
  const nlohmann::json shown = opened_in_browser(scratch, all);
  for (const std::string &one : all)
    EXPECT_FALSE(shown[one]["ran"].get<bool>()) << one;
  for (const std::string &one : answering)
    EXPECT_NE(shown[one]["answer"].get<std::string>().find("one turn in"), std::string::npos)
      << one << ": " << shown[one]["answer"];
  EXPECT_NE(shown[address("__proto__")]["words"].get<std::string>().find("other=__proto__"),
            std::string::npos);
  for (const std::string &one : refusing)
    EXPECT_EQ(shown[one]["answer"].get<std::string>().find("Not available in this page: "), 0u)
      << one << ": " << shown[one]["answer"];
}

} // namespace
} // namespace stemware::test
