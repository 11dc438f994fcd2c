#pragma once

#include "fem/pipeline/base/json.h"

#include <string>

/// Pages: HTML, style and script of page/ with an embedded document of results or solver. The browser makes
/// pictures, tables and surrounding sentences.
namespace stemware::pipeline
{

/// Returns a self-contained page of @p document, with @p title and @p answer for browsers without scripts.
std::string page_of(const Json &document, const std::string &title, const std::string &answer);

/// Returns a self-contained page that solves a study at every move of a slider. @p data: pairs of glass and
/// table with their studies; @p bodies, @p wasm: compliances and solver, gzip in base64.
std::string live_page(const Json &data, const std::string &bodies, const std::string &wasm,
                      const std::string &title, const std::string &answer);

} // namespace stemware::pipeline
