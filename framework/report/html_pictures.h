// The pictures of a page: side by side pixel for pixel, magnified, one over the other, and error maps with their scale.
#pragma once

#include "report/markup.h"
#include "report/report_data.h"

namespace moire::report {

// The style sheet that holds every picture once; the elements below refer to it by class.
Markup picture_styles(const ReportData& data);

// The images of a scene in three ways.
Markup side_by_side(const ReportData& data, const SceneView& view);
Markup magnified(const ReportData& data, const SceneView& view);
Markup one_over_the_other(const ReportData& data, const SceneView& view, std::size_t scene_index);

// Another row of pictures, with the scale of its colours if it has one.
Markup picture_row(const ReportData& data, const PictureRow& row);

}  // namespace moire::report
