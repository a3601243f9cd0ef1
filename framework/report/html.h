// report.html: one page that holds everything, opens from disk and asks no network.
#pragma once

#include <filesystem>
#include <string>

#include "report/report_data.h"

namespace moire::report {

std::string html_text(const ReportData& data);

// Makes report.html of a folder with results.json, manifest.json and the pictures they name. Error: results that cannot
// be read, or a page that cannot be written.
void write_html(const std::filesystem::path& folder);

}  // namespace moire::report
