#include "pixels/segment_index.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "world/cut.h"

namespace shadow_planes {

namespace {

// Pixels that a segment comes this near to, in pixels, count as crossed.
constexpr double near = 1e-9;
// Shorter ones have no direction that is good for cutting, and nothing worth to cut.
constexpr double shortest = 1e-9;

// The part of a segment on the side where a linear value is not negative. False: nothing.
bool keep(moire::Pole& a, moire::Pole& b, const Line& side) {
  const double at_a = side(a), at_b = side(b);
  if (at_a < 0 && at_b < 0) return false;
  if (at_a < 0) {
    a = between(b, a, at_b / (at_b - at_a));
  } else if (at_b < 0) {
    b = between(a, b, at_a / (at_a - at_b));
  }
  return true;
}

}  // namespace

SegmentIndex::SegmentIndex(const std::vector<CriticalLine>& lines, const Camera& camera, moire::ImageSize size)
    : size_(size), rows_(static_cast<std::size_t>(size.height)) {
  // What is behind the eye is on the wrong side of one of these.
  const std::array<Line, 4> sides{Line{1, 0, 0}, Line{-1, 0, static_cast<double>(size.width)}, Line{0, 1, 0},
                                  Line{0, -1, static_cast<double>(size.height)}};
  for (const CriticalLine& line : lines) {
    moire::Pole a = camera.image_of(line.from), b = camera.image_of(line.to);
    if (!std::all_of(sides.begin(), sides.end(), [&](const Line& side) { return keep(a, b, side); })) continue;
    if (!(a.w > 0 && b.w > 0)) continue;
    const moire::Point from{a.x / a.w, a.y / a.w}, to{b.x / b.w, b.y / b.w};
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > shortest)) continue;
    const Line through = edge_line(from, to);
    segments_.push_back({from, to, {through.a / length, through.b / length, through.c / length}});
    enter(static_cast<std::uint32_t>(segments_.size() - 1));
  }
  for (auto& row : rows_) {
    std::sort(row.begin(), row.end(),
              [](const Cell& p, const Cell& q) { return p.x != q.x ? p.x < q.x : p.segment < q.segment; });
  }
}

void SegmentIndex::enter(std::uint32_t segment) {
  moire::Point a = segments_[segment].from, b = segments_[segment].to;
  if (a.y > b.y) std::swap(a, b);
  const auto pixel = [](double at, int count) { return std::clamp(static_cast<int>(std::floor(at)), 0, count - 1); };
  const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  for (int y = pixel(a.y - near, size_.height); y <= pixel(b.y + near, size_.height); ++y) {
    double x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x);
    if (b.y > a.y) {
      const double top = a.x + slope * (std::clamp<double>(y, a.y, b.y) - a.y);
      const double bottom = a.x + slope * (std::clamp<double>(y + 1, a.y, b.y) - a.y);
      x0 = std::max(x0, std::min(top, bottom));
      x1 = std::min(x1, std::max(top, bottom));
    }
    const int last = pixel(x1 + near, size_.width);
    for (int x = pixel(x0 - near, size_.width); x <= last; ++x)
      rows_[static_cast<std::size_t>(y)].push_back({x, segment});
  }
}

std::span<const SegmentIndex::Cell> SegmentIndex::in_pixel(int x, int y) const {
  const auto& row = rows_[static_cast<std::size_t>(y)];
  const auto [from, to] =
      std::equal_range(row.begin(), row.end(), Cell{x, 0}, [](const Cell& p, const Cell& q) { return p.x < q.x; });
  return {from, to};
}

bool SegmentIndex::any_in(const moire::PixelArea& area) const {
  for (int y = area.y0; y < area.y0 + area.height; ++y) {
    const auto& row = rows_[static_cast<std::size_t>(y)];
    const auto first = std::lower_bound(row.begin(), row.end(), area.x0, [](const Cell& c, int x) { return c.x < x; });
    if (first != row.end() && first->x < area.x0 + area.width) return true;
  }
  return false;
}

}  // namespace shadow_planes
