// The numbers of a scene as HTML tables, one a metric pass, and what each metric means.
#pragma once

#include "report/markup.h"
#include "report/metric_table.h"

namespace moire::report {

Markup metric_tables(const Results& results, const MetricTable& table);

// Every metric with its unit, direction and meaning; the heads of the tables point here.
Markup glossary(const Results& results);

// A table that scrolls by itself where it is too wide. `rows` are <tr>s.
Markup scrolling_table(const std::string& label, const Markup& head, const Markup& rows);

}  // namespace moire::report
