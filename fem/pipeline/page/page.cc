#include "fem/pipeline/page/page.h"

#include "fem/pipeline/support/html.h"
#include "fem/pipeline/system/json_text.h"
#include "fem/pipeline/system/output.h"
#include "fem/pipeline/system/shared_files.h"

namespace stemware::pipeline
{

/// HTML, style and script of both pages: modules of page/js with those of views or live, joined by CMake.
const CompiledTexts &report_page_texts();

std::string report_page(const nlohmann::ordered_json &document, const std::string &title,
                        const std::string &answer)
{
  const CompiledTexts &texts = report_page_texts();
  return with_marks_replaced(text_of(texts, "page.html"),
                             { { "WRITTEN_BY", written_by_stemware },
                               { "TITLE", html_text(title) },
                               { "ANSWER", html_text(answer) },
                               { "STYLE", text_of(texts, "style.css") },
                               { "DOCUMENT", json_within_html(document) },
                               { "SHA256", base64_of_digits(STEMWARE_PAGE_SHA256) },
                               { "SCRIPT", text_of(texts, "script.js") } });
}

std::string live_page(std::map<std::string, std::string> parts)
{
  const CompiledTexts &texts = report_page_texts();
  parts.merge(
    std::map<std::string, std::string>{ { "WRITTEN_BY", written_by_stemware },
                                        { "STYLE", text_of(texts, "style.css") + text_of(texts, "live.css") },
                                        { "WORKER", text_of(texts, "worker.js") },
                                        { "SHA256", base64_of_digits(STEMWARE_LIVE_SHA256) },
                                        { "SCRIPT", text_of(texts, "live.js") } });
  return with_marks_replaced(text_of(texts, "live.html"), parts);
}

} // namespace stemware::pipeline
