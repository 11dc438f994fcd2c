#include "fem/pipeline/page/page.h"

#include "fem/pipeline/support/html.h"
#include "fem/pipeline/system/json_text.h"
#include "fem/pipeline/system/output.h"
#include "fem/pipeline/system/shared_files.h"

namespace stemware::pipeline
{

/// HTML, style and scripts of the page: modules of page/, joined by CMake.
const CompiledTexts &report_page_texts();

std::string page_of(const nlohmann::ordered_json &document, const std::string &title,
                    const std::string &answer, const std::optional<LivePart> &live)
{
  const CompiledTexts &texts = report_page_texts();
  const std::string files =
    document.is_null() ? "" : " All numbers are in summary.json and the CSV files beside it.";
  std::map<std::string, std::string> parts = {
    { "WRITTEN_BY", written_by_stemware },
    { "TITLE", html_text(title) },
    { "ANSWER", html_text(answer) },
    { "NO_SCRIPT",
      "Pictures, tables and sliders of this page need JavaScript. If only these lines are shown, this site "
      "or browser runs no scripts: save the file and open it in a browser of May 2023 or later." +
        files },
    { "STYLE", text_of(texts, "style.css") },
    { "LIVE", "" },
    { "LIVE_POLICY", "" },
    { "DOCUMENT", json_within_html(document) },
    { "SHA256", base64_of_digits(live ? STEMWARE_LIVE_SHA256 : STEMWARE_PAGE_SHA256) },
    { "SCRIPT", text_of(texts, live ? "live.js" : "script.js") }
  };
  if (live)
  {
    parts["STYLE"] += text_of(texts, "live.css");
    parts["LIVE_POLICY"] = " 'wasm-unsafe-eval'; worker-src blob:";
    parts["LIVE"] =
      with_marks_replaced(text_of(texts, "live.html"), { { "DATA", json_within_html(live->data) },
                                                         { "BODIES", live->bodies },
                                                         { "WASM", live->wasm },
                                                         { "WORKER", text_of(texts, "worker.js") } });
  }
  return with_marks_replaced(text_of(texts, "page.html"), parts);
}

} // namespace stemware::pipeline
