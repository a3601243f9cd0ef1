// Siemens' star.
#include "kinds/kinds.h"
#include "kinds/two_valued.h"

namespace pattern {

namespace {

// Wedge k lies between rays k and k + 1 from the middle, clockwise; light where k is even.
class Star final : public TwoValued<Star> {
 public:
  Star(const Look& look, int spokes, double angle_deg) : TwoValued(look), wedges_(2 * spokes), angle_deg_(angle_deg) {
    for (int k = 0; k <= wedges_; ++k) rays_.push_back(direction(angle_deg + 360.0 * k / wedges_));
    rays_.back() = rays_.front();
  }

  moire::Hit at(moire::Point p) const { return seen(wedge_at(p - look().middle(), none)); }

  template <class Weights>
  void cover(const Weights& weights, moire::PixelBlock& block) const {
    const double radius = weights.radius();
    int wedge = none, column = block.x0;
    fill(block, [&](int x, int y, auto deposit) {
      const moire::Point from_middle = middle_of(x, y) - look().middle();
      // Farther out, a line through the middle that meets the pixel does so on the middle's one side.
      if (std::max(std::abs(from_middle.x), std::abs(from_middle.y)) < 2 * radius) {
        around_middle(weights, from_middle, deposit);
        wedge = none;
        return;
      }
      wedge = wedge_at(from_middle, x == column ? wedge : none);
      column = x;
      // From the first wedge that reaches into the pixel to the last.
      const auto beyond = [&](int k) {
        const moire::Point ray = rays_[index(k)];
        return weights.half_plane(std::abs(ray.y), std::abs(ray.x), cross(ray, from_middle));
      };
      const auto is_met = [&](int k) {
        const moire::Point ray = rays_[index(k)];
        return std::abs(cross(ray, from_middle)) < radius * (std::abs(ray.x) + std::abs(ray.y));
      };
      int k = wedge;
      while (is_met(k)) --k;
      double above = 1;
      for (bool is_last = false; !is_last; ++k) {
        is_last = !is_met(k + 1);
        double rest = is_last ? 0 : beyond(k + 1);
        if constexpr (Weights::is_positive) rest = std::min(rest, above);
        const moire::Hit hit = seen(index(k));
        deposit(hit.element, above - rest, hit.color);
        above = rest;
      }
    });
  }

 private:
  static constexpr int none = -1;

  int index(int k) const { return ((k % wedges_) + wedges_) % wedges_; }
  moire::Hit seen(int k) const { return {part(k), look().greys.of(k % 2 == 0)}; }

  // The wedge of a point, sought from that of a neighbour: what is found does not depend on it.
  int wedge_at(moire::Point from_middle, int k) const {
    if (from_middle == moire::Point{}) return 0;
    if (k == none) {
      const double turns = std::atan2(from_middle.y, from_middle.x) / (2 * std::numbers::pi) - angle_deg_ / 360;
      k = index(static_cast<int>(std::floor((turns - std::floor(turns)) * wedges_)));
    }
    while (cross(rays_[index(k)], from_middle) < 0) k = index(k - 1);
    while (cross(rays_[index(k + 1)], from_middle) >= 0) k = index(k + 1);
    return k;
  }

  // Each wedge as a triangle that ends beyond the pixel.
  template <class Weights, class Deposit>
  void around_middle(const Weights& weights, moire::Point from_middle, Deposit deposit) const {
    const double half_angle = std::numbers::pi / wedges_;
    const double far = 3.1 * std::numbers::sqrt2 * weights.radius() / std::cos(half_angle);
    const moire::Point apex{-from_middle.x, -from_middle.y};
    for (int k = 0; k < wedges_; ++k) {
      const moire::Point p = apex + far * rays_[index(k)], q = apex + far * rays_[index(k + 1)];
      const double weight = weights.along(apex, p) + weights.along(p, q) + weights.along(q, apex);
      if (Weights::is_nothing(weight)) continue;
      deposit(seen(k).element, weight, seen(k).color);
    }
  }
  int wedges_;
  double angle_deg_;
  std::vector<moire::Point> rays_;  // directions; the first again at the end
};

}  // namespace

std::unique_ptr<moire::Frame> make_star(const Look& look, int spokes, double angle_deg) {
  return std::make_unique<Star>(look, spokes, angle_deg);
}

}  // namespace pattern
