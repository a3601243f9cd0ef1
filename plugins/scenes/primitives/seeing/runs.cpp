#include "runs.h"

#include <algorithm>
#include <cmath>

namespace primitives {

void Runs::meet_shapes(const Ray& ray, double begin, double end) {
  const auto at = [&](double t) { return moire::Point{ray.origin.x + t * ray.ex, ray.origin.y + t * ray.ey}; };
  ++line_;
  met_.clear();
  cells_.along(at(begin), at(end), [&](std::uint32_t k) {
    if (seen_[k] == line_) return;
    seen_[k] = line_;
    for (const Span& span : meet(shapes_[k], ray)) {
      if (span.end > begin && span.begin < end) met_.push_back({span.begin, std::min(span.end, end), k});
    }
  });
  std::ranges::sort(met_, {}, &Run::begin);
}

std::span<const Run> Runs::along(moire::Point from, moire::Point to, double begin, double end) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  meet_shapes({from, (to.x - from.x) / length, (to.y - from.y) / length}, begin, end);

  const auto is_behind = [](const Run& a, const Run& b) { return a.shape < b.shape; };
  open_.clear();
  runs_.clear();
  auto next = met_.begin();
  for (double here = begin; here < end;) {
    for (; next != met_.end() && next->begin <= here; ++next) {
      open_.push_back(*next);
      std::ranges::push_heap(open_, is_behind);
    }
    while (!open_.empty() && open_.front().end <= here) {
      std::ranges::pop_heap(open_, is_behind);
      open_.pop_back();
    }
    const std::uint32_t front = open_.empty() ? Run::nothing : open_.front().shape;
    double there = open_.empty() ? end : open_.front().end;
    if (next != met_.end()) there = std::min(there, next->begin);
    if (!runs_.empty() && runs_.back().shape == front) {
      runs_.back().end = there;
    } else {
      runs_.push_back({here, there, front});
    }
    here = there;
  }
  return runs_;
}

}  // namespace primitives
