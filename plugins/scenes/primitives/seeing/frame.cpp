#include "frame.h"

#include <algorithm>

#include <moire/runs.h>

#include "outlines.h"
#include "runs.h"

namespace primitives {

PrimitivesFrame::PrimitivesFrame(std::vector<Curve> curves, moire::ImageSize size, moire::Color background,
                                 double tolerance)
    : curves_(std::move(curves)), size_(size), background_(background), tolerance_(tolerance) {
  for (const Curve& curve : curves_) {
    std::visit(
        [&](const auto& c) {
          const auto shape = shape_of(c);
          if (!shape) return;
          shapes_.push_back(*shape);
          hits_.push_back({c.element, c.color});
        },
        curve);
  }
}

const Cells& PrimitivesFrame::cells() const {
  std::call_once(cells_once_, [this] { cells_.emplace(shapes_, size_); });
  return *cells_;
}

void PrimitivesFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                            moire::Counters& counters) const {
  const Cells& index = cells();
  std::uint64_t found = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const moire::Point p{points[k].x, points[k].y};
    hits[k] = {moire::background, background_};
    for (const std::uint32_t shape : index.at(p)) {
      if (!contains(shapes_[shape], p)) continue;
      hits[k] = hits_[shape];
      ++found;
      break;
    }
  }
  counters.queries += points.size();
  counters.hits += found;
}

void PrimitivesFrame::along(std::span<const moire::ImageLine> lines, const moire::Lookup*, moire::Tally& pieces) const {
  Runs runs(shapes_, cells());
  const moire::Hit nothing{moire::background, background_};
  moire::deposit_runs(
      lines, pieces,
      [&](const moire::ImageLine& line, double begin, double end) {
        return runs.along(line.from, line.to, begin, end);
      },
      [&](const Run& run) { return run.shape == Run::nothing ? nothing : hits_[run.shape]; });
}

void PrimitivesFrame::stream(const moire::Rectangle& window, moire::PolygonSink& sink) const {
  constexpr double margin = 64;  // pixels around the image in which arcs are fine, too
  const moire::Rectangle fine{-margin, -margin, size_.width + margin, size_.height + margin};
  Outline outline;
  for (std::size_t k = shapes_.size(); k-- > 0;) {
    // Corners of a polygon lie a little outside of its circle.
    const moire::Rectangle box = box_of(shapes_[k]);
    const bool touches = box.x0 - tolerance_ <= window.x1 && box.x1 + tolerance_ >= window.x0 &&
                         box.y0 - tolerance_ <= window.y1 && box.y1 + tolerance_ >= window.y0;
    if (!touches) continue;
    outline_of(shapes_[k], fine, tolerance_, outline);
    if (outline.contours.empty()) continue;
    sink.polygon({hits_[k].element, hits_[k].color, moire::FillRule::even_odd, outline.points, outline.contours});
  }
}

void PrimitivesFrame::stream(moire::CurveSink& sink) const {
  for (const Curve& curve : curves_) {
    if (const auto* line = std::get_if<moire::LineCurve>(&curve)) {
      sink.line(*line);
    } else {
      sink.circle(std::get<moire::CircleCurve>(curve));
    }
  }
}

}  // namespace primitives
