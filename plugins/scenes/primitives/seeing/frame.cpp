#include "frame.h"

#include <algorithm>

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
  Runs all(shapes_, cells());
  std::size_t first_slot = 0;
  pieces.fill([&](auto add) {
    for (const moire::ImageLine& line : lines) {
      if (line.stretches() > 0 && line.cuts.front() < line.cuts.back()) {
        const auto runs = all.along(line.from, line.to, line.cuts.front(), line.cuts.back());
        auto run = runs.begin();
        for (std::size_t i = 0; i < line.stretches(); ++i) {
          const double begin = line.cuts[i], end = line.cuts[i + 1];
          if (!(begin < end)) continue;
          ++pieces.counters.queries;
          while (run->end <= begin) ++run;
          for (auto part = run; part != runs.end() && part->begin < end; ++part) {
            const bool is_hit = part->shape != Run::nothing;
            const moire::Hit hit = is_hit ? hits_[part->shape] : moire::Hit{moire::background, background_};
            add(first_slot + i, hit.element, std::min(part->end, end) - std::max(part->begin, begin), hit.color);
            pieces.counters.hits += is_hit ? 1 : 0;
          }
        }
      }
      first_slot += line.stretches();
    }
  });
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
