#include "frame.h"

#include <algorithm>
#include <limits>

#include <moire/runs.h>

#include "points.h"
#include "runs.h"
#include "stack.h"

namespace cartoon {

CartoonFrame::CartoonFrame(std::shared_ptr<const Outlines> outlines, const moire::Affine& placement,
                           moire::ImageSize size, moire::Color background, moire::Blend blend)
    : outlines_(std::move(outlines)), placement_(placement), size_(size), background_(background), blend_(blend) {
  points_.reserve(outlines_->points().size());
  boxes_.reserve(outlines_->layers());
  hits_.reserve(outlines_->layers() + 1);
  for (std::size_t k = 0; k < outlines_->layers(); ++k) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    moire::Rectangle box{infinity, infinity, -infinity, -infinity};
    for (std::size_t i = points_.size(); i < outlines_->point_end(k); ++i) {
      const moire::Point p = placement_(outlines_->points()[i]);
      points_.push_back(p);
      box.x0 = std::min(box.x0, p.x), box.x1 = std::max(box.x1, p.x);
      box.y0 = std::min(box.y0, p.y), box.y1 = std::max(box.y1, p.y);
    }
    boxes_.push_back(box);
    hits_.push_back({k + 1, outlines_->layer(k).color});
  }
  hits_.push_back({moire::background, background_});
}

const Edges& CartoonFrame::edges() const {
  std::call_once(edges_once_, [this] { edges_.emplace(*outlines_, points_, size_.width); });
  return *edges_;
}

void CartoonFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                         moire::Counters& counters) const {
  counters.queries += points.size();
  counters.hits += find_hits(edges(), hits_, points, hits);
}

void CartoonFrame::along(std::span<const moire::ImageLine> lines, const moire::Lookup*, moire::Tally& pieces) const {
  LineCutter cutter(*outlines_, points_, edges());
  moire::deposit_runs(
      lines, pieces,
      [&](const moire::ImageLine& line, double begin, double end) {
        return cutter.runs(line.from, line.to, begin, end);
      },
      [&](const LineRun& run) { return run.layer == Stack::empty ? hits_.back() : hits_[run.layer]; });
}

void CartoonFrame::stream(const moire::Rectangle& window, moire::PolygonSink& sink) const {
  for (std::size_t k = outlines_->layers(); k-- > 0;) {
    const moire::Rectangle& box = boxes_[k];
    const bool touches = box.x0 <= window.x1 && box.x1 >= window.x0 && box.y0 <= window.y1 && box.y1 >= window.y0;
    if (touches) sink.polygon(outlines_->polygon(k, points_));
  }
}

void CartoonFrame::stream(moire::PolygonSink& sink) const {
  for (std::size_t k = outlines_->layers(); k-- > 0;) {
    const moire::Polygon polygon = outlines_->polygon(k, outlines_->points());
    if (!polygon.contours.empty()) sink.polygon(polygon);
  }
}

}  // namespace cartoon
