// The benchmark's results as one HTML page: plots, tables and sentences, all made here; nothing is loaded from
// elsewhere.
#pragma once

#include <string>

#include "base/result.hpp"

namespace tyndall::bench {

/// `resultsJson` is the text of a results.json (format "tyndall-bench", version 1). What is null or missing there is
/// left out of the page. Error: not JSON, another format or version, or a field of the wrong type or out of range,
/// which is named by its path, such as "points[3].gpu_ms.median". The page is HTML and well-formed XML.
Result<std::string> reportHtml(const std::string& resultsJson);

}  // namespace tyndall::bench
