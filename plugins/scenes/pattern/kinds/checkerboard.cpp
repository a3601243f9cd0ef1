// A checkerboard, upright or turned.
#include <array>

#include "kinds/kinds.h"
#include "kinds/two_valued.h"

namespace pattern {

namespace {

// (u, v): along the board's own axes, in cells.
class Checkerboard final : public TwoValued<Checkerboard> {
 public:
  Checkerboard(const Look& look, double cell, double angle_deg)
      : TwoValued(look), cell_(cell), across_(direction(angle_deg)), down_{-across_.y, across_.x} {}

  moire::Hit at(moire::Point p) const {
    const moire::Point at = on_board(p);
    return seen(index(at.x), index(at.y));
  }

  template <class Weights>
  void cover(const Weights& weights, moire::PixelBlock& block) const {
    const HalfPlanes<Weights> beyond(weights, (1 / cell_) * across_);
    const double reach = beyond.reach();
    const bool is_upright = across_.x == 0 || across_.y == 0;
    fill(block, [&](int x, int y, auto deposit) {
      const moire::Point at = on_board(middle_of(x, y));
      const std::int64_t i0 = index(at.x - reach), i1 = index(at.x + reach);
      const std::int64_t j0 = index(at.y - reach), j1 = index(at.y + reach);
      const auto between = [&](double place, std::int64_t k) {
        return beyond(place - static_cast<double>(k)) - beyond(place - static_cast<double>(k + 1));
      };
      for (std::int64_t i = i0; i <= i1; ++i) {
        for (std::int64_t j = j0; j <= j1; ++j) {
          double weight = 1;
          if (is_upright || i0 == i1 || j0 == j1) {
            if (i0 != i1) weight *= between(at.x, i);
            if (j0 != j1) weight *= between(at.y, j);
          } else {
            weight = around(weights, at, 2 * reach, i, j);
          }
          if (Weights::is_nothing(weight)) continue;
          const moire::Hit hit = seen(i, j);
          deposit(hit.element, weight, hit.color);
        }
      }
    });
  }

 private:
  static std::int64_t index(double place) { return static_cast<std::int64_t>(std::floor(place)); }
  moire::Hit seen(std::int64_t i, std::int64_t j) const { return {part(i, j), look().greys.of((i + j) % 2 == 0)}; }
  moire::Point on_board(moire::Point p) const {
    const moire::Point from_middle = p - look().middle();
    return {dot(across_, from_middle) / cell_, dot(down_, from_middle) / cell_};
  }
  // What cell (i, j) weighs in the pixel about `at`, which reaches less far than `far`.
  template <class Weights>
  double around(const Weights& weights, moire::Point at, double far, std::int64_t i, std::int64_t j) const {
    const auto side = [far](double place, std::int64_t k) {
      return std::clamp(static_cast<double>(k) - place, -far, far);
    };
    const auto corner = [&](std::int64_t u, std::int64_t v) {
      return (cell_ * side(at.x, u)) * across_ + (cell_ * side(at.y, v)) * down_;
    };
    const std::array corners{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += weights.along(corners[k], corners[(k + 1) % 4]);
    return sum;
  }

  double cell_;
  moire::Point across_, down_;
};

}  // namespace

std::unique_ptr<moire::Frame> make_checkerboard(const Look& look, double cell, double angle_deg) {
  return std::make_unique<Checkerboard>(look, cell, angle_deg);
}

}  // namespace pattern
