#include "octants.h"

namespace scan_conversion {

Rows offsets_between(double radius, double low, double high) {
  const auto offset = [radius](double u) { return u >= radius ? 0 : std::sqrt((radius - u) * (radius + u)); };
  // Two rows, for the width of what is drawn, and what rounding may be worth.
  const double margin = 2 + radius * 0x1p-48;
  const double least = offset(std::max(high + margin, 0.0)), most = offset(std::max(low - margin, 0.0));
  if (high < -margin || low > radius + margin) return {};
  return {static_cast<std::int64_t>(std::max(least - margin, 0.0)), static_cast<std::int64_t>(most + margin) + 1};
}

VisibleRows::VisibleRows(const PixelCircle& circle, std::int64_t last, const moire::PixelArea& area) {
  const Rows x{area.x0 - circle.center.x, area.x0 + area.width - circle.center.x};
  const Rows y{area.y0 - circle.center.y, area.y0 + area.height - circle.center.y};
  const auto mirrored = [](Rows rows, bool is) { return is ? Rows{1 - rows.end, 1 - rows.first} : rows; };
  std::array<Rows, 8> found;
  for (unsigned image = 0; image < 8; ++image) {
    // Of the axis along which i is counted, and of that of j.
    const Rows u = mirrored(image & 1 ? y : x, image & 2), v = mirrored(image & 1 ? x : y, image & 4);
    const Rows rows = offsets_between(static_cast<double>(circle.radius), static_cast<double>(u.first),
                                      static_cast<double>(u.end - 1));
    found[image] = {std::max({v.first, rows.first, std::int64_t{0}}), std::min({v.end, rows.end, last + 1})};
  }
  std::sort(found.begin(), found.end(), [](Rows a, Rows b) { return a.first < b.first; });
  for (const Rows rows : found) {
    if (rows.first >= rows.end) continue;
    if (count_ > 0 && rows.first <= ranges_[count_ - 1].end) {
      ranges_[count_ - 1].end = std::max(ranges_[count_ - 1].end, rows.end);
    } else {
      ranges_[count_++] = rows;
    }
  }
}

}  // namespace scan_conversion
