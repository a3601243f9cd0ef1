// The looks of report.html, from page.css.
#pragma once

namespace moire::report {

extern const char* const stylesheet;

}  // namespace moire::report
