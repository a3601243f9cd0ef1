#include "plugins/heightfield/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moire::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double uncertainty = 1e-9;  // of a voxel, and of a unit of height
constexpr double degree = std::numbers::pi / 180;

// A stretch of a ray, in multiples of its direction.
struct Interval {
  double begin, end;
  bool empty() const { return !(begin < end); }
};

Interval cut(Interval a, Interval b) { return {std::max(a.begin, b.begin), std::min(a.end, b.end)}; }

// Where eye + t direction lies between low and high.
Interval between(double low, double high, double eye, double direction) {
  if (direction == 0) return low <= eye && eye < high ? Interval{-infinity, infinity} : Interval{0, 0};
  const double a = (low - eye) / direction, b = (high - eye) / direction;
  return {std::min(a, b), std::max(a, b)};
}

// Where on `stretch` the ray is first below `top`; infinity if nowhere.
double first_below(double top, Interval stretch, double eye, double direction) {
  if (stretch.empty()) return infinity;
  if (eye + stretch.begin * direction < top) return stretch.begin;
  if (direction >= 0) return infinity;
  const double t = (top - eye) / direction;
  return t < stretch.end ? t : infinity;
}

// A ray within the far limit, moved out or in by `grown`.
Interval reach(const View& view, Ray ray, double grown) {
  const double advance = std::hypot(ray.x, ray.y);
  const double far = std::max(0.0, view.far + grown * std::min(view.spacing_x, view.spacing_y));
  return {0, advance > 0 ? far / advance : (far > 0 ? infinity : 0)};
}

// The elements that may be seen: those met, if grown, before any is met for sure.
class Candidates {
 public:
  void add(Element element, double met_if_grown, double met_if_shrunk) {
    sure_ = std::min(sure_, met_if_shrunk);
    if (met_if_grown < infinity) met_.push_back({element, met_if_grown});
  }
  std::vector<Element> result() const {
    std::vector<Element> elements;
    for (const auto& [element, t] : met_) {
      if (t <= sure_) elements.push_back(element);
    }
    if (sure_ == infinity) elements.push_back(background);
    return elements;
  }

 private:
  double sure_ = infinity;
  std::vector<std::pair<Element, double>> met_;
};

}  // namespace

Ray ray_through(const View& view, double image_x, double image_y) {
  const double scale = std::tan(view.fov * degree / 2) / view.size.width;
  const double sideways = (2 * image_x - view.size.width) * scale, upward = (view.size.height - 2 * image_y) * scale;
  const double pitch = view.pitch * degree, yaw = view.yaw * degree;
  const double level = std::cos(pitch) - upward * std::sin(pitch);
  return {level * std::cos(yaw) - sideways * std::sin(yaw), level * std::sin(yaw) + sideways * std::cos(yaw),
          std::sin(pitch) + upward * std::cos(pitch)};
}

Point image_of(const View& view, Ray direction) {
  const double pitch = view.pitch * degree, yaw = view.yaw * degree;
  const double level = direction.x * std::cos(yaw) + direction.y * std::sin(yaw);
  const double sideways = direction.y * std::cos(yaw) - direction.x * std::sin(yaw);
  const double depth = level * std::cos(pitch) + direction.z * std::sin(pitch);
  const double upward = direction.z * std::cos(pitch) - level * std::sin(pitch);
  const double scale = view.size.width / std::tan(view.fov * degree / 2) / depth;
  return {(view.size.width + sideways * scale) / 2, (view.size.height - upward * scale) / 2};
}

namespace {

// Calls visit(element, top, grown, shrunk) for every box that the ray passes above or through, with the stretch of the
// ray over the box moved out and in by the uncertainty.
template <class Visit>
void for_each_box(const Map& map, const View& view, Ray ray, Visit visit) {
  const auto first = [&](double eye, double spacing) {
    return static_cast<std::int64_t>(std::floor((eye - view.far) / spacing)) - 1;
  };
  const auto last = [&](double eye, double spacing) {
    return static_cast<std::int64_t>(std::floor((eye + view.far) / spacing)) + 1;
  };
  const auto across = [&](std::int64_t index, double spacing, double eye, double direction, double grown) {
    const double low = static_cast<double>(index) * spacing, high = static_cast<double>(index + 1) * spacing;
    return between(low - grown * spacing, high + grown * spacing, eye, direction);
  };
  const Interval grown_reach = reach(view, ray, uncertainty), shrunk_reach = reach(view, ray, -uncertainty);
  for (std::int64_t j = first(view.y, view.spacing_y); j <= last(view.y, view.spacing_y); ++j) {
    const Interval grown_row = cut(grown_reach, across(j, view.spacing_y, view.y, ray.y, uncertainty));
    const Interval shrunk_row = cut(shrunk_reach, across(j, view.spacing_y, view.y, ray.y, -uncertainty));
    if (grown_row.empty()) continue;
    for (std::int64_t i = first(view.x, view.spacing_x); i <= last(view.x, view.spacing_x); ++i) {
      const Interval grown = cut(grown_row, across(i, view.spacing_x, view.x, ray.x, uncertainty));
      if (grown.empty()) continue;
      const Interval shrunk = cut(shrunk_row, across(i, view.spacing_x, view.x, ray.x, -uncertainty));
      visit(texel_element(0, i, j), static_cast<double>(map.height(i, j)), grown, shrunk);
    }
  }
}

}  // namespace

std::vector<Element> seen_by(const Map& map, const View& view, Ray ray) {
  Candidates candidates;
  for_each_box(map, view, ray, [&](Element element, double top, Interval grown, Interval shrunk) {
    candidates.add(element, first_below(top + uncertainty, grown, view.z, ray.z),
                   first_below(top - uncertainty, shrunk, view.z, ray.z));
  });
  return candidates.result();
}

std::vector<Element> wall_seen_by(const Map& map, const View& view, Ray ray) {
  Candidates candidates;
  for_each_box(map, view, ray, [&](Element element, double top, Interval grown, Interval shrunk) {
    // Of a ray that falls, the wall moved out stands below a higher place.
    const double one = view.z + grown.begin * ray.z, other = view.z + shrunk.begin * ray.z;
    const bool may_meet = std::min(one, other) < top + uncertainty;
    const bool meets = !shrunk.empty() && std::max(one, other) < top - uncertainty;
    candidates.add(element, may_meet ? grown.begin : infinity, meets ? shrunk.begin : infinity);
  });
  return candidates.result();
}

std::vector<Element> seen_by_major_steps(const Map& map, const View& view, Ray ray) {
  const double east = ray.x / view.spacing_x, south = ray.y / view.spacing_y;  // voxels
  const bool rows_are_steps = std::abs(south) > std::abs(east);
  const double advance = rows_are_steps ? south : east, drift = (rows_are_steps ? east : south) / advance;
  const double eye = rows_are_steps ? view.y / view.spacing_y : view.x / view.spacing_x;
  const double other_eye = rows_are_steps ? view.x / view.spacing_x : view.y / view.spacing_y;

  const Interval grown_reach = reach(view, ray, uncertainty), shrunk_reach = reach(view, ray, -uncertainty);
  const int forth = advance < 0 ? -1 : 1;
  // A ray that goes back from a border starts in the voxel before it.
  auto step = static_cast<std::int64_t>(forth > 0 ? std::floor(eye) : std::ceil(eye) - 1);
  Candidates candidates;
  for (;; step += forth) {
    const auto low = static_cast<double>(step);
    const Interval grown = between(low - uncertainty, low + 1 + uncertainty, eye, advance);
    const Interval shrunk = between(low + uncertainty, low + 1 - uncertainty, eye, advance);
    if (grown.begin > grown_reach.end) break;
    const double ahead = (low + 0.5 - eye) * forth > 0 ? low + 0.5 - eye : 0;
    const double middle = other_eye + ahead * drift;
    const auto a = static_cast<std::int64_t>(std::floor(middle - uncertainty));
    const auto b = static_cast<std::int64_t>(std::floor(middle + uncertainty));
    for (std::int64_t other = a; other <= b; ++other) {
      const std::int64_t i = rows_are_steps ? other : step, j = rows_are_steps ? step : other;
      const double top = map.height(i, j);
      const double met = first_below(top + uncertainty, cut(grown_reach, grown), view.z, ray.z);
      const double sure = first_below(top - uncertainty, cut(shrunk_reach, shrunk), view.z, ray.z);
      candidates.add(texel_element(0, i, j), met, a == b ? sure : infinity);
    }
  }
  return candidates.result();
}

}  // namespace moire::test
