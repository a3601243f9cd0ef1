#include "pictures/footprint_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <fmt/format.h>

#include <moire/error.h>

namespace moire {

namespace {

constexpr std::int64_t largest_extent = 8192;  // texels of level 0
constexpr int wanted_side = 480;               // pixels of the picture, about

enum class Place : std::uint8_t { outside, hidden, missed, sampled, leaked };

Color color_of(Place place) {
  constexpr std::array colors{footprint_colors::outside, footprint_colors::hidden, footprint_colors::missed,
                              footprint_colors::sampled, footprint_colors::leaked};
  return colors[static_cast<std::size_t>(place)];
}

// A rectangle of texels of level 0, ends excluded.
struct Extent2 {
  std::int64_t i0 = std::numeric_limits<std::int64_t>::max(), j0 = i0;
  std::int64_t i1 = std::numeric_limits<std::int64_t>::min(), j1 = i1;

  void include(const Extent2& other) {
    i0 = std::min(i0, other.i0), j0 = std::min(j0, other.j0);
    i1 = std::max(i1, other.i1), j1 = std::max(j1, other.j1);
  }
};

Extent2 extent_of(Element element) {
  const auto [level, i, j] = texel_index(element);
  return {i << level, j << level, (i + 1) << level, (j + 1) << level};
}

struct Corner {
  std::int64_t i, j;
  friend auto operator<=>(const Corner&, const Corner&) = default;
};

std::int64_t turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i);
}

// Andrew's monotone chain: the two chains of the convex hull between its first and its last point.
struct Hull {
  std::vector<Corner> lower, upper;

  explicit Hull(std::vector<Corner> points) {
    std::sort(points.begin(), points.end());
    for (const Corner& p : points) {
      append(lower, p, 1);
      append(upper, p, -1);
    }
  }

  // The row where a chain is at `i`, the middle of a column that the hull reaches. Exact wherever it is the middle of a
  // row, so that no place on the hull's edge is taken for one inside: a quotient that is a double comes out as that
  // double.
  static double at(const std::vector<Corner>& chain, double i) {
    const auto next = std::find_if(chain.begin() + 1, chain.end() - 1,
                                   [&](const Corner& c) { return static_cast<double>(c.i) >= i; });
    const Corner &a = *(next - 1), &b = *next;
    return static_cast<double>(a.j) +
           static_cast<double>(b.j - a.j) * (i - static_cast<double>(a.i)) / static_cast<double>(b.i - a.i);
  }

 private:
  static void append(std::vector<Corner>& chain, const Corner& p, int side) {
    while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) * side <= 0) chain.pop_back();
    if (chain.size() == 1 && chain.back().i == p.i) {
      if ((p.j - chain.back().j) * side < 0) chain.back() = p;
      return;
    }
    chain.push_back(p);
  }
};

// The map around the footprint, a place for each texel of level 0.
class Plan {
 public:
  explicit Plan(const Extent2& extent)
      : extent_(extent),
        width_(static_cast<std::size_t>(extent.i1 - extent.i0)),
        height_(static_cast<std::size_t>(extent.j1 - extent.j0)),
        places_(width_ * height_, Place::outside) {}

  void fill_hull(const Hull& hull) {
    // The map may reach beyond the hull, where what is sampled though hidden lies.
    const auto column = [&](const Corner& c) { return static_cast<std::size_t>(c.i - extent_.i0); };
    for (std::size_t i = column(hull.lower.front()); i < column(hull.lower.back()); ++i) {
      const double middle = static_cast<double>(extent_.i0) + static_cast<double>(i) + 0.5;
      const double a = Hull::at(hull.lower, middle), b = Hull::at(hull.upper, middle);
      for (std::size_t j = 0; j < height_; ++j) {
        const double row = static_cast<double>(extent_.j0) + static_cast<double>(j) + 0.5;
        if (row > a && row < b) places_[j * width_ + i] = Place::hidden;
      }
    }
  }

  void fill(Element element, Place place) {
    const Extent2 e = extent_of(element);
    for (std::int64_t j = e.j0; j < e.j1; ++j) {
      for (std::int64_t i = e.i0; i < e.i1; ++i) {
        places_[static_cast<std::size_t>(j - extent_.j0) * width_ + static_cast<std::size_t>(i - extent_.i0)] = place;
      }
    }
  }

  std::size_t count(Place place) const {
    return static_cast<std::size_t>(std::count(places_.begin(), places_.end(), place));
  }

  // Whole pixels a texel, or the mean of whole texels a pixel: a footprint's picture is no place for aliasing.
  Picture picture() const {
    const std::size_t side = std::max(width_, height_);
    const std::size_t texels = (side + wanted_side - 1) / wanted_side,
                      pixels = std::max<std::size_t>(wanted_side / side, 1);
    const std::size_t columns = (width_ + texels - 1) / texels * pixels,
                      rows = (height_ + texels - 1) / texels * pixels;
    Picture picture{{static_cast<int>(columns), static_cast<int>(rows)}, std::vector<Color>(columns * rows)};
    for (std::size_t y = 0; y < rows; ++y) {
      for (std::size_t x = 0; x < columns; ++x) picture.pixels[y * columns + x] = mean(x / pixels, y / pixels, texels);
    }
    return picture;
  }

 private:
  Color mean(std::size_t x, std::size_t y, std::size_t texels) const {
    Color sum{0, 0, 0};
    for (std::size_t j = y * texels; j < (y + 1) * texels; ++j) {
      for (std::size_t i = x * texels; i < (x + 1) * texels; ++i) {
        const Color c = color_of(i < width_ && j < height_ ? places_[j * width_ + i] : Place::outside);
        sum.r += c.r, sum.g += c.g, sum.b += c.b;
      }
    }
    const auto n = static_cast<float>(texels * texels);
    return {sum.r / n, sum.g / n, sum.b / n};
  }

  Extent2 extent_;
  std::size_t width_, height_;
  std::vector<Place> places_;
};

bool contains(const std::vector<Element>& elements, Element element) {
  return std::binary_search(elements.begin(), elements.end(), element);
}

}  // namespace

FootprintPlan footprint_plan(const std::vector<Element>& visible, const std::vector<Element>& seen) {
  FootprintPlan result;
  Extent2 extent;
  std::vector<Corner> corners;
  for (Element element : visible) {
    const Extent2 e = extent_of(element);
    extent.include(e);
    corners.insert(corners.end(), {{e.i0, e.j0}, {e.i1, e.j0}, {e.i0, e.j1}, {e.i1, e.j1}});
  }
  for (Element element : seen) extent.include(extent_of(element));
  if (visible.empty() && seen.empty()) {
    result.picture = {{1, 1}, {footprint_colors::outside}};
    return result;
  }
  if (std::max(extent.i1 - extent.i0, extent.j1 - extent.j0) > largest_extent) {
    throw Error(fmt::format("footprint: spans {} x {} texels, at most {} are shown; choose a smaller window",
                            extent.i1 - extent.i0, extent.j1 - extent.j0, largest_extent));
  }

  Plan plan(extent);
  if (!visible.empty()) plan.fill_hull(Hull(std::move(corners)));
  // Backwards: rising elements begin with the finest level, which is to lie on top.
  for (auto element = seen.rbegin(); element != seen.rend(); ++element) {
    if (contains(visible, *element)) continue;
    plan.fill(*element, Place::leaked);
    ++result.leaked;
  }
  for (auto element = visible.rbegin(); element != visible.rend(); ++element) {
    const bool sampled = contains(seen, *element);
    plan.fill(*element, sampled ? Place::sampled : Place::missed);
    ++(sampled ? result.sampled : result.missed);
  }
  result.hidden = plan.count(Place::hidden);
  result.picture = plan.picture();
  return result;
}

}  // namespace moire
