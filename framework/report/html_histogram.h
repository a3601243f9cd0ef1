// Shares that add up to 1, a bar for each line of a scene's table: how far pixels change from frame to frame.
#pragma once

#include "report/markup.h"
#include "report/metric_table.h"

namespace moire::report {

// Of the metrics "flicker.changed_by_...", in their order, the darker the larger the change; nothing without them.
Markup change_histogram(const Results& results, const MetricTable& table, const std::string& scene);

}  // namespace moire::report
