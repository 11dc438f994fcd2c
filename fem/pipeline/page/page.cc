#include "fem/pipeline/page/page.h"

#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/text_file.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <map>
#include <string>
#include <utility>

namespace stemware::pipeline
{

/// Returns the HTML of the pages, scripts, styles and their checksums, which are compiled into the program.
const CompiledTexts &page_texts();

namespace
{

/// Returns @p text with each mark /*NAME*/ replaced by the text of this name. Marks in inserted texts remain.
std::string with_marks_replaced(const std::string &text, const std::map<std::string, std::string> &texts)
{
  const std::string begin = "/*", end = "*/";
  std::string result;
  std::size_t written = 0;
  for (std::size_t mark = text.find(begin); mark < text.size(); mark = text.find(begin, written))
  {
    const std::size_t name = mark + begin.size(), name_end = text.find(end, name);
    result += text.substr(written, mark - written) + texts.at(text.substr(name, name_end - name));
    written = name_end + end.size();
  }
  return result + text.substr(written);
}

std::string html_text(std::string text)
{
  for (const auto &[character, entity] :
       { std::pair("&", "&amp;"), std::pair("<", "&lt;"), std::pair(">", "&gt;"), std::pair("\"", "&quot;"),
         std::pair("'", "&#39;") })
    boost::replace_all(text, character, entity);
  return text;
}

/// Returns the base64 form of hexadecimal @p digits, the format of checksums in a Content-Security-Policy.
std::string base64_of_digits(const std::string &digits)
{
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  return std::string(Letters(bytes.cbegin()), Letters(bytes.cend())) +
         std::string((3 - bytes.size() % 3) % 3, '=');
}

std::string filled(const std::string &title, const std::string &answer,
                   std::map<std::string, std::string> parts)
{
  parts.insert({ { "WRITTEN_BY", written_by_stemware },
                 { "TITLE", html_text(title) },
                 { "ANSWER", html_text(answer) } });
  return with_marks_replaced(text_of(page_texts(), "page.html"), parts);
}

std::string check_sum(const std::string &file)
{
  return base64_of_digits(text_of(page_texts(), file).substr(0, 64));
}

constexpr auto no_script =
  "Pictures, tables and sliders of this page need JavaScript. If only these lines are shown, this site "
  "or browser runs no scripts: save the file and open it in a browser of May 2023 or later.";

} // namespace

std::string page_of(const Json &document, const std::string &title, const std::string &answer)
{
  const CompiledTexts &texts = page_texts();
  const std::string content =
    R"(<script type="application/json" id="document">)" + json_within_html(document) + "</script>";
  return filled(title, answer,
                { { "NO_SCRIPT", std::string(no_script) +
                                   " All numbers are in summary.json and the CSV files beside it." },
                  { "STYLE", text_of(texts, "style.css") },
                  { "POLICY", "" },
                  { "CONTENT", content },
                  { "SHA256", check_sum("script.sha256") },
                  { "SCRIPT", text_of(texts, "script.js") } });
}

std::string live_page(const Json &data, const std::string &bodies, const std::string &wasm,
                      const std::string &title, const std::string &answer)
{
  const CompiledTexts &texts = page_texts();
  const std::string content =
    with_marks_replaced(text_of(texts, "live.html"), { { "DATA", json_within_html(data) },
                                                       { "BODIES", bodies },
                                                       { "WASM", wasm },
                                                       { "WORKER", text_of(texts, "worker.js") } });
  return filled(title, answer,
                { { "NO_SCRIPT", no_script },
                  { "STYLE", text_of(texts, "style.css") + text_of(texts, "live.css") },
                  { "POLICY", " 'wasm-unsafe-eval'; worker-src blob:" },
                  { "CONTENT", content },
                  { "SHA256", check_sum("live.sha256") },
                  { "SCRIPT", text_of(texts, "live.js") } });
}

} // namespace stemware::pipeline
