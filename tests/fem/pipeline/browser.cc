#include "tests/fem/pipeline/browser.h"

#include "fem/pipeline/base/json.h"

#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace stemware::test
{

std::string script_string(const std::string &text)
{
  return pipeline::json_within_html(text);
}

std::string in_one_line(const std::string &text)
{
  std::istringstream words(
    boost::replace_all_copy(boost::replace_all_copy(text, "\u00a0", " "), "\u2212", "-"));
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

std::string axe_script()
{
  return "const axe_source = " + script_string(read_text(STEMWARE_AXE)) // empty if axe-core is not installed
         + R"(;
const serious = async shown => {
  if (!axe_source)
    return [];
  // A copy of the page without its scripts and without its policy, which forbids the test's scripts.
  const copy = shown.document.documentElement.cloneNode(true);
  for (const part of copy.querySelectorAll("script, meta[http-equiv]"))
    part.remove();
  const frame = document.createElement("iframe");
  frame.style = "border:0;height:900px;width:" + shown.innerWidth + "px";
  frame.srcdoc = "<!DOCTYPE html>" + copy.outerHTML;
  const loaded = new Promise(done => frame.onload = done);
  document.body.append(frame);
  await loaded;
  const page = frame.contentWindow;
  page.eval(axe_source);
  return page.axe.run().then(
    found => found.violations.filter(one => one.impact == "serious" || one.impact == "critical")
               .map(one => one.id + ": " + one.nodes.map(node => node.html.slice(0, 120)).join(" | ")),
    error => ["axe-core does not run: " + error]).finally(() => frame.remove());
};
)";
}

std::string troubles_script()
{
  return R"(const troubles = page => Array.from(page.querySelectorAll("figure svg")).flatMap(svg => {
  const frame = svg.getBoundingClientRect(), name = svg.closest("figure").id, found = [];
  const texts = Array.from(svg.querySelectorAll("text"))
    .map(text => ({ words: text.textContent.trim(), box: text.getBoundingClientRect() }))
    .filter(text => text.words && text.box.width > 0);
  for (const { words, box } of texts)
    if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 ||
        box.bottom > frame.bottom + 1)
      found.push(name + ": '" + words + "' is cut off");
  for (let i = 0; i < texts.length; ++i)
    for (let j = 0; j < i; ++j) {
      const a = texts[i].box, b = texts[j].box;
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (width > 2 && height > 0.3 * Math.min(a.height, b.height))
        found.push(name + ": '" + texts[i].words + "' lies on '" + texts[j].words + "'");
    }
  // An axis with one number has no scale.
  for (const anchor of ["middle", "end"]) {
    const numbers = [...svg.querySelectorAll(`text.soft[text-anchor=${anchor}]`)].filter(text => /^[−\d.]+( · 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?$|^10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+$/.test(text.textContent));
    if (numbers.length == 1)
      found.push(name + ": '" + numbers[0].textContent + "' is the only number of an axis");
  }
  return found;
}).concat([...page.querySelectorAll("main *")].filter(node => !node.closest(".wide, svg, .said"))
  .filter(node => node.getBoundingClientRect().right > page.documentElement.clientWidth + 1)
  .map(node => node.tagName + " '" + node.textContent.slice(0, 60) + "' reaches beyond the page"));
)";
}

std::string hostile_text()
{
  const std::string script = "document.documentElement.dataset.ran=1";
  return "<img src=x onerror=\"" + script + "\"> </SCRIPT><SCRIPT>" + script +
         "</SCRIPT> <!--<script> `touch PWN` $(touch PWN) /*BODIES*/ /*SCRIPT*/ {{title}} '; system('touch "
         "PWN') "
         "\u2028 \u2029 & \" \\";
}

std::string framed(const std::string &page, int width)
{
  return "const frame = document.createElement('iframe');\nframe.style = 'border:0;height:900px;width:" +
         std::to_string(width) + "px';\nframe.srcdoc = " + script_string(page) +
         ";\ndocument.body.append(frame);\n";
}

nlohmann::json found_in_browser(const ScratchFolder &scratch, const std::string &script, bool forbids)
{
  // An open frame delays the load event until the script has ended.
  const std::string page =
    R"(<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,"><body><script>
const holder = document.createElement("iframe");
document.body.append(holder);
holder.contentDocument.open();
(async () => {
)" + script +
    R"(
})().catch(error => ({ failed: String(error) })).then(found => {
  const closing = holder.contentDocument;
  const text = JSON.stringify(found).replace(/[<>&\u00a0]/g, c => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0"));
  document.body.textContent = "FOUND" + text + "FOUND";
  console.log("the browser has found");
  closing.close();
});
</script></body>)";
  const std::string file = scratch.write("found.html", page);
  const Ended ended = chromium(scratch, { "--allow-file-access-from-files", "--dump-dom", "file://" + file });
  if (!forbids)
  {
    // The only console message is "the browser has found".
    EXPECT_EQ(all_between(ended.err, ":CONSOLE", "\n").size(), 1u) << ended.err;
  }
  const nlohmann::json found = nlohmann::json::parse(between(ended.out, "FOUND", "FOUND"), nullptr, false);
  EXPECT_TRUE(!found.is_discarded() && !found.contains("failed")) << ended.out.substr(0, 500) << ended.err;
  return found;
}

nlohmann::json opened_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses)
{
  return found_in_browser(scratch,
                          "const addresses = " + script_string(nlohmann::json(addresses).dump()) + R"(;
  const found = {};
  for (const address of JSON.parse(addresses)) {
    const frame = document.createElement("iframe");
    frame.style = "border:0;height:900px;width:1100px";
    frame.src = address;
    const loaded = new Promise(done => frame.onload = done);
    document.body.append(frame);
    await loaded;
    const page = frame.contentDocument, live = page.querySelector("#answer");
    for (let i = 0; i < 600 && live && !page.body.dataset.rested && !live.matches(".falls"); ++i)
      await new Promise(done => setTimeout(done, 50));
    const answer = live || page.querySelector("p.answer");
    found[address] = { answer: answer ? answer.textContent : "", words: page.body ? page.body.innerText : "",
                       ran: "ran" in page.documentElement.dataset };
    frame.remove();
  }
  return found;)");
}

nlohmann::json reports_in_browser(const ScratchFolder &scratch, const std::vector<std::string> &addresses)
{
  return found_in_browser(scratch, axe_script() + troubles_script() + "const addresses = " +
                                     script_string(nlohmann::json(addresses).dump()) + R"(;
  const found = {}, no_number = /NaN|undefined|Infinity|\[object/;
  const parsed = csv => csv.trim().split("\r\n").map(row => row.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/)
    .map(cell => cell.replace(/^"|"$/g, "").replaceAll('""', '"')));
  for (const address of JSON.parse(addresses)) {
    const frame = document.createElement("iframe"), flaws = [], figures = {}, tables = {}, blobs = [];
    frame.style = "border:0;height:900px;width:1100px";
    frame.src = address;
    const loaded = new Promise(done => frame.onload = done);
    document.body.append(frame);
    await loaded;
    const page = frame.contentDocument, { contentWindow } = frame;
    contentWindow.URL.createObjectURL = blob => (blobs.push(blob), "data:,");
    contentWindow.HTMLAnchorElement.prototype.click = () => {};
    if (!page.body.dataset.complete)
      flaws.push("the script has not ended");
    page.querySelectorAll("details").forEach(fold => fold.open = true);
    await new Promise(done => setTimeout(done, 100)); // pictures in folds are redrawn
    if (no_number.test(page.body.innerText))
      flaws.push("the text has " + page.body.innerText.match(/.{0,60}(NaN|undefined|Infinity|\[object).{0,60}/)[0]);
    const content = async button => {
      button.click();
      return blobs.pop().text();
    };
    for (const figure of page.querySelectorAll("figure")) {
      if (no_number.test(figure.querySelector("svg").outerHTML))
        flaws.push("no number is in the picture " + figure.id);
      figures[figure.id] = [];
      const [svg, , csv] = figure.querySelectorAll("figcaption button.file");
      if (!svg)
        continue;
      const text = await content(svg), file = new DOMParser().parseFromString(text, "image/svg+xml");
      if (file.querySelector("parsererror") || text.includes("var(--"))
        flaws.push("no SVG: " + text.slice(0, 200));
      const rows = (figures[figure.id] = parsed(await content(csv)));
      if (rows[0].includes("") || rows.some(row => row.length != rows[0].length))
        flaws.push("the CSV of " + figure.id + " has other columns than headings: " + rows[0]);
    }
    for (const table of page.querySelectorAll("table")) {
      const title = table.caption.firstChild ? table.caption.innerText.replace(/ CSV$/, "") : "";
      tables[title] = [...table.rows].map(row => [...row.cells].map(cell => cell.innerText));
    }
    flaws.push(...await serious(contentWindow));
    for (const width of [1100, 400]) {
      frame.style.width = width + "px";
      await new Promise(done => setTimeout(done, 300)); // pictures are redrawn
      flaws.push(...troubles(page).map(trouble => trouble + " at " + width + " px"));
    }
    for (const { name } of contentWindow.performance.getEntriesByType("resource"))
      if (!/^(data|blob):/.test(name))
        flaws.push("the page asks for " + name);
    for (const link of page.querySelectorAll("dl a"))
      if (!(await fetch(link.href)).ok)
        flaws.push("no file " + link.href);
    found[address] = { answer: page.querySelector("p.answer").textContent, flaws, figures, tables };
    frame.remove();
  }
  return found;)");
}

std::string without_policy(const std::string &page)
{
  const std::size_t begin = page.find("<meta http-equiv=\"Content-Security-Policy\"");
  EXPECT_NE(begin, std::string::npos);
  const std::size_t end = std::min(page.find('>', begin), page.size() - 1);
  return page.substr(0, begin) + page.substr(end + 1);
}

Ended chromium(const ScratchFolder &scratch, const std::vector<std::string> &arguments)
{
  std::vector<std::string> command = { "chromium",
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
