#include "exact/curves/annulus.h"

namespace area {

Annulus::Annulus(moire::Point center, double radius)
    : column_(std::floor(center.x)), row_(std::floor(center.y)), x_(center.x - column_), y_(center.y - row_) {
  if (radius > 0) outer_.emplace(std::floor(radius), radius - std::floor(radius));
  keep_pairs();
}

Annulus::Annulus(const moire::CircleCurve& circle) : Annulus(circle.center, 0) {
  if (!(circle.width > 0)) return;
  // Whole parts apart, so that nothing is rounded at the size of the radius.
  const double whole_radius = std::floor(circle.radius), half = circle.width / 2, whole_half = std::floor(half);
  const double radius = circle.radius - whole_radius, rest = half - whole_half;
  outer_.emplace(whole_radius + whole_half, radius + rest);
  if (circle.radius > half) inner_.emplace(whole_radius - whole_half, radius - rest);
  keep_pairs();
}

void Annulus::keep_pairs() {
  if (!outer_) return;
  const bool has_hole = inner_.has_value();
  squares_ = {outer_->whole_square(), has_hole ? inner_->whole_square() : -1};
  rests_ = {outer_->rest_of_square(), has_hole ? inner_->rest_of_square() : 0};
  inverses_ = {outer_->inverse(), has_hole ? inner_->inverse() : 0};
}

moire::PixelArea Annulus::bounds(const moire::PixelArea& clip) const {
  const double reach = outer_->value() * (1 + 0x1p-40) + 0x1p-40;
  const auto within = [&](double center, int first, int count, int& from, int& size) {
    from = std::max(first, whole(std::floor(center - reach)));
    size = std::max(0, std::min(first + count, whole(std::ceil(center + reach))) - from);
  };
  moire::PixelArea all;
  within(column_ + x_, clip.x0, clip.width, all.x0, all.width);
  within(row_ + y_, clip.y0, clip.height, all.y0, all.height);
  return all;
}

}  // namespace area
