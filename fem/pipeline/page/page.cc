#include "fem/pipeline/page/page.h"

#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/text_file.h"

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/replace.hpp>

#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Returns the HTML of the pages, scripts, styles and their checksums, which are compiled into the program.
const CompiledTexts &page_texts();

namespace
{

std::string html_text(std::string text)
{
  for (const auto &[character, entity] :
       { std::pair("&", "&amp;"), std::pair("<", "&lt;"), std::pair(">", "&gt;"), std::pair("\"", "&quot;"),
         std::pair("'", "&#39;") })
    boost::replace_all(text, character, entity);
  return text;
}

/// Returns the checksum of a script in the format of a Content-Security-Policy: base64 of the bytes whose
/// hexadecimal digits are in @p file.
std::string check_sum(const std::string &file)
{
  const std::string &digits = text_of(page_texts(), file);
  std::vector<unsigned char> bytes(32);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<unsigned char>(std::stoi(digits.substr(2 * i, 2), nullptr, 16));
  return dealii::Utilities::encode_base64(bytes);
}

/// Returns page.html with its parts; @p parts are named arguments of fmt.
template <typename... Parts>
std::string filled(const std::string &title, const std::string &answer, const Parts &...parts)
{
  return fmt::format(fmt::runtime(text_of(page_texts(), "page.html")),
                     fmt::arg("WRITTEN_BY", written_by_stemware), fmt::arg("TITLE", html_text(title)),
                     fmt::arg("ANSWER", html_text(answer)), parts...);
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
                fmt::arg("NO_SCRIPT", std::string(no_script) +
                                        " All numbers are in summary.json and the CSV files beside it."),
                fmt::arg("STYLE", text_of(texts, "style.css")), fmt::arg("POLICY", ""),
                fmt::arg("CONTENT", content), fmt::arg("SHA256", check_sum("script.sha256")),
                fmt::arg("SCRIPT", text_of(texts, "script.js")));
}

std::string live_page(const Json &data, const std::string &bodies, const std::string &wasm,
                      const std::string &title, const std::string &answer)
{
  const CompiledTexts &texts = page_texts();
  const std::string content = fmt::format(
    fmt::runtime(text_of(texts, "live.html")), fmt::arg("DATA", json_within_html(data)),
    fmt::arg("BODIES", bodies), fmt::arg("WASM", wasm), fmt::arg("WORKER", text_of(texts, "worker.js")));
  return filled(title, answer, fmt::arg("NO_SCRIPT", no_script),
                fmt::arg("STYLE", text_of(texts, "style.css") + text_of(texts, "live.css")),
                fmt::arg("POLICY", " 'wasm-unsafe-eval'; worker-src blob:"), fmt::arg("CONTENT", content),
                fmt::arg("SHA256", check_sum("live.sha256")), fmt::arg("SCRIPT", text_of(texts, "live.js")));
}

} // namespace stemware::pipeline
