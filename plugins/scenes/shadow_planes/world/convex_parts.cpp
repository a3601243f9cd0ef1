#include "world/convex_parts.h"

#include <algorithm>

namespace shadow_planes {

namespace {

using Loop = std::vector<std::size_t>;

// Twice the area of a triangle, above 0 if counterclockwise.
double turn(const moire::Point& a, const moire::Point& b, const moire::Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool differ(double p, double q) { return (p > 0 && q < 0) || (p < 0 && q > 0); }

class Cutter {
 public:
  explicit Cutter(std::span<const moire::Point> polygon) : points_(polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) rest_.push_back(k);
    drop_straight_corners();
  }

  std::vector<Loop> parts() {
    if (rest_.size() < 3) return {};
    if (is_convex(rest_)) return {rest_};
    cut_ears();
    join();
    return std::move(parts_);
  }

 private:
  double turn_at(const Loop& loop, std::size_t k) const {
    const std::size_t n = loop.size();
    return turn(points_[loop[(k + n - 1) % n]], points_[loop[k]], points_[loop[(k + 1) % n]]);
  }
  bool is_convex(const Loop& loop) const {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (turn_at(loop, k) < 0) return false;
    }
    return true;
  }

  // Doubled ones and the ends of spikes among them.
  void drop_straight_corners() {
    for (std::size_t k = 0, straight_on = 0; rest_.size() >= 3 && straight_on < rest_.size();) {
      k %= rest_.size();
      if (turn_at(rest_, k) == 0) {
        rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(k));
        k = k == 0 ? rest_.size() - 1 : k - 1;
        straight_on = 0;
      } else {
        ++k, ++straight_on;
      }
    }
  }

  bool is_ear(std::size_t k) const {
    const std::size_t n = rest_.size();
    const moire::Point &a = points_[rest_[(k + n - 1) % n]], &b = points_[rest_[k]], &c = points_[rest_[(k + 1) % n]];
    if (!(turn(a, b, c) > 0)) return false;
    return std::none_of(rest_.begin(), rest_.end(), [&](std::size_t corner) {
      const moire::Point& p = points_[corner];
      return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

  // Rounding may hide the ears of needles: then the corner that turns most is taken.
  std::size_t next_ear() const {
    std::size_t most = 0;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      if (is_ear(k)) return k;
      if (turn_at(rest_, k) > turn_at(rest_, most)) most = k;
    }
    return most;
  }

  void cut_ears() {
    while (rest_.size() > 3) {
      const std::size_t n = rest_.size(), ear = next_ear();
      parts_.push_back({rest_[(ear + n - 1) % n], rest_[ear], rest_[(ear + 1) % n]});
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    parts_.push_back(rest_);
    std::erase_if(parts_, [&](const Loop& part) { return !(turn_at(part, 1) > 0); });
  }

  // The two parts beside an inner side, in one, if that is convex.
  void join() {
    for (std::size_t one = 0; one < parts_.size(); ++one) {
      for (std::size_t other = one + 1; other < parts_.size();) {
        Loop joined = joined_of(parts_[one], parts_[other]);
        if (!joined.empty() && is_convex(joined)) {
          parts_[one] = std::move(joined);
          parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(other));
          other = one + 1;  // what would not fit before may fit now
        } else {
          ++other;
        }
      }
    }
  }
  static Loop joined_of(const Loop& one, const Loop& other) {
    for (std::size_t k = 0; k < one.size(); ++k) {
      for (std::size_t j = 0; j < other.size(); ++j) {
        const bool share = one[k] == other[(j + 1) % other.size()] && one[(k + 1) % one.size()] == other[j];
        if (!share) continue;
        Loop joined;
        for (std::size_t i = 1; i <= one.size(); ++i) joined.push_back(one[(k + i) % one.size()]);
        for (std::size_t i = 2; i < other.size(); ++i) joined.push_back(other[(j + i) % other.size()]);
        return joined;
      }
    }
    return {};
  }

  std::span<const moire::Point> points_;
  Loop rest_;
  std::vector<Loop> parts_;
};

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> first_crossing(std::span<const moire::Point> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k) {
    const moire::Point &a = polygon[k], &b = polygon[(k + 1) % n];
    for (std::size_t j = k + 1; j < n; ++j) {
      const moire::Point &c = polygon[j], &d = polygon[(j + 1) % n];
      if (differ(turn(a, b, c), turn(a, b, d)) && differ(turn(c, d, a), turn(c, d, b))) return std::pair{k, j};
    }
  }
  return {};
}

std::vector<std::vector<std::size_t>> convex_parts(std::span<const moire::Point> polygon) {
  return Cutter(polygon).parts();
}

}  // namespace shadow_planes
