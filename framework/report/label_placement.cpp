// Where to write labels beside points so that they neither overlap each other nor hide what is drawn.
#include "report/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moire::report {
namespace {

constexpr double point_radius = 7;

// Directions in the order of preference: right, left, above, below, then the diagonals.
constexpr std::array<Point, 8> directions = {{{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};
constexpr std::array<double, 5> distances = {10, 20, 34, 52, 76};

double overlap(const Rectangle& a, const Rectangle& b) {
  const double width = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
  const double height = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
  return width > 0 && height > 0 ? width * height : 0;
}

double outside(const Rectangle& box, const Rectangle& bounds) {
  return std::max(0.0, bounds.x0 - box.x0) + std::max(0.0, box.x1 - bounds.x1) + std::max(0.0, bounds.y0 - box.y0) +
         std::max(0.0, box.y1 - bounds.y1);
}

// The box whose edge or corner nearest to the point is `distance` away in that direction.
Rectangle box_beside(const LabelWish& wish, double height, Point direction, double distance) {
  const bool is_diagonal = direction.x != 0 && direction.y != 0;
  const double step = is_diagonal ? distance * std::sqrt(0.5) : distance;
  const double x = wish.point.x + direction.x * (step + wish.width / 2);
  const double y = wish.point.y + direction.y * (step + height / 2);
  return {x - wish.width / 2, y - height / 2, x + wish.width / 2, y + height / 2};
}

struct Surroundings {
  const Rectangle& bounds;
  std::vector<Rectangle> points;
  std::span<const Rectangle> obstacles;
  std::vector<Rectangle> labels;

  double cost(const Rectangle& box) const {
    double sum = 1e4 * outside(box, bounds);
    for (const Rectangle& label : labels) sum += 100 * overlap(box, label);
    for (const Rectangle& point : points) sum += 50 * overlap(box, point);
    for (const Rectangle& obstacle : obstacles) sum += 10 * overlap(box, obstacle);
    return sum;
  }
};

PlacedLabel cheapest(const LabelWish& wish, double height, const Surroundings& around) {
  PlacedLabel best;
  double least = HUGE_VAL;
  for (std::size_t ring = 0; ring < distances.size(); ++ring) {
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const Rectangle box = box_beside(wish, height, directions[d], distances[ring]);
      const double cost = around.cost(box) + distances[ring] + 0.1 * static_cast<double>(d);
      if (cost < least) {
        least = cost;
        best = {box, ring > 0};
      }
    }
  }
  return best;
}

}  // namespace

std::vector<PlacedLabel> place_labels(std::span<const LabelWish> wishes, double height, const Rectangle& bounds,
                                      std::span<const Rectangle> obstacles) {
  Surroundings around{bounds, {}, obstacles, {}};
  for (const LabelWish& wish : wishes) {
    const Point p = wish.point;
    around.points.push_back({p.x - point_radius, p.y - point_radius, p.x + point_radius, p.y + point_radius});
  }
  std::vector<PlacedLabel> placed;
  for (const LabelWish& wish : wishes) {
    placed.push_back(cheapest(wish, height, around));
    around.labels.push_back(placed.back().box);
  }
  return placed;
}

}  // namespace moire::report
