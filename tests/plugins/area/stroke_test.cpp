// Rectangles of lines, against polygons clipped to pixels in extended precision.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "exact/curves/stroke.h"
#include "support/hard_pixels/sketch.h"

namespace moire::test {
namespace {

using Number = long double;
struct Corner {
  Number x, y;
};
using Outline = std::vector<Corner>;

// The rectangle, counted from a pixel's corner.
Outline rectangle(const LineCurve& line, int x, int y) {
  const Number x0 = line.from.x - Number(x), y0 = line.from.y - Number(y);
  const Number x1 = line.to.x - Number(x), y1 = line.to.y - Number(y), half = line.width / 2.0L;
  const Number length = std::hypot(x1 - x0, y1 - y0), dx = half * (x1 - x0) / length, dy = half * (y1 - y0) / length;
  const Number out = line.cap == Cap::square ? 1 : 0;
  return {{x0 - out * dx - dy, y0 - out * dy + dx},
          {x1 + out * dx - dy, y1 + out * dy + dx},
          {x1 + out * dx + dy, y1 + out * dy - dx},
          {x0 - out * dx + dy, y0 - out * dy - dx}};
}

// The part where value(corner), linear, is not negative.
template <class Value>
Outline part(const Outline& outline, Value value) {
  Outline result;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Corner &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const Number va = value(a), vb = value(b);
    if (va >= 0) result.push_back(a);
    if ((va < 0) != (vb < 0))
      result.push_back({a.x + va / (va - vb) * (b.x - a.x), a.y + va / (va - vb) * (b.y - a.y)});
  }
  return result;
}

double clipped(const LineCurve& line, int x, int y) {
  Outline outline = rectangle(line, x, y);
  outline = part(outline, [](const Corner& p) { return p.x; });
  outline = part(outline, [](const Corner& p) { return 1 - p.x; });
  outline = part(outline, [](const Corner& p) { return p.y; });
  outline = part(outline, [](const Corner& p) { return 1 - p.y; });
  Number doubled = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Corner &a = outline[k], &b = outline[(k + 1) % outline.size()];
    doubled += a.x * b.y - b.x * a.y;
  }
  return static_cast<double>(std::abs(doubled) / 2);
}

using Image = std::map<std::pair<int, int>, double>;

Image image(const LineCurve& line, const PixelArea& clip) {
  Image image;
  area::Stroke(line).areas(clip, [&](int x, int y, double area) {
    CHECK((area >= 0 && area <= 1));
    if (area > 0) CHECK(image.emplace(std::pair(x, y), area).second);
    CHECK((x >= clip.x0 && y >= clip.y0 && x < clip.x0 + clip.width && y < clip.y0 + clip.height));
  });
  return image;
}

// The largest error of all pixels of the window.
double error(const LineCurve& line, const PixelArea& window) {
  const Image found = image(line, window);
  double largest = 0;
  for (int y = window.y0; y < window.y0 + window.height; ++y) {
    for (int x = window.x0; x < window.x0 + window.width; ++x) {
      const auto pixel = found.find({x, y});
      const double area = pixel == found.end() ? 0 : pixel->second;
      largest = std::max(largest, std::abs(area - clipped(line, x, y)));
    }
  }
  return largest;
}

PixelArea around(const LineCurve& line) {
  const double margin = line.width + 2;
  const int x0 = static_cast<int>(std::floor(std::min(line.from.x, line.to.x) - margin));
  const int y0 = static_cast<int>(std::floor(std::min(line.from.y, line.to.y) - margin));
  return {x0, y0, static_cast<int>(std::ceil(std::max(line.from.x, line.to.x) + margin)) - x0,
          static_cast<int>(std::ceil(std::max(line.from.y, line.to.y) + margin)) - y0};
}

// Heights are sums of a few numbers of the size of a pixel, or of the line's width where that is more.
double bound(const LineCurve& line) { return 1e-14 * std::max(1.0, line.width); }

LineCurve turned(LineCurve line, int octant) {
  for (Point* p : {&line.from, &line.to}) {
    if (octant & 1) std::swap(p->x, p->y);
    if (octant & 2) p->x = 20 - p->x;
    if (octant & 4) p->y = 20 - p->y;
  }
  return line;
}

}  // namespace

TEST_CASE("the rectangle of a line has its exact area in each pixel at every slope") {
  hard::Chance random(1);
  double largest = 0;
  for (int power = -1; power <= 12; ++power) {
    for (const double width : {1.0, 0.02, 3.3}) {
      for (int k = 0; k < 16; ++k) {
        const double slope = power < 0 ? 0 : std::pow(10.0, -power), length = random.between(0.05, 18);
        const Point from{random.between(2, 4), random.between(5, 7)};
        LineCurve line{1, {}, from, {from.x + length, from.y + slope * length}, width};
        line.cap = k % 2 == 0 ? Cap::butt : Cap::square;
        line = turned(line, k % 8);
        const double off = error(line, around(line));
        INFO(fmt::format("slope {} of length {}, width {}, from {} {}", slope, length, width, from.x, from.y));
        CHECK(off <= bound(line));
        largest = std::max(largest, off / bound(line));
      }
    }
  }
  CAPTURE(largest);
  CHECK(largest > 1e-3);  // it has something to say
}

TEST_CASE("lines with ends on corners of pixels, at 45 degrees, tiny and wide ones have their exact areas") {
  hard::Chance random(2);
  const auto check = [](const LineCurve& line) {
    INFO(fmt::format("{} {} to {} {}, width {}", line.from.x, line.from.y, line.to.x, line.to.y, line.width));
    CHECK(error(line, around(line)) <= bound(line));
  };
  for (const Cap cap : {Cap::butt, Cap::square}) {
    for (int k = 0; k < 60; ++k) {
      const auto whole = [&] { return std::floor(random.between(0, 9)); };
      LineCurve line{1, {}, {whole(), whole()}, {whole() + 10, whole()}, k % 3 == 0 ? 1.0 : 2.0, cap};
      check(line);
      check({1, {}, {whole(), whole()}, {10, 10}, std::sqrt(2.0), cap});
      const Point at{random.between(0, 4), random.between(0, 4)};
      check({1, {}, at, {at.x + random.between(-1e-9, 1e-9), at.y + 1e-9}, 1, cap});
      check({1, {}, at, {at.x + random.between(-.3, .3), at.y + random.between(-.3, .3)}, 1e-6, cap});
      check({1, {}, at, {at.x + random.between(-3, 3), at.y + random.between(-3, 3)}, 20, cap});
    }
  }
}

// What is far away is multiplied by the slope: the ends' errors must not be.
TEST_CASE("long lines have exact areas far from their ends") {
  hard::Chance random(3);
  for (int k = 0; k < 400; ++k) {
    const double reach = std::pow(10.0, random.between(2, 4.5));
    const Point middle{random.between(400, 600), random.between(400, 600)};
    const double angle = random.between(0, 6.3), x = reach * std::cos(angle), y = reach * std::sin(angle);
    const double part = random.between(0.1, 0.9);
    LineCurve line{1, {}, {middle.x - part * x, middle.y - part * y}, {}, random.between(0.5, 3)};
    line.to = {middle.x + (1 - part) * x, middle.y + (1 - part) * y};
    const PixelArea window{static_cast<int>(middle.x) - 2, static_cast<int>(middle.y) - 2, 5, 5};
    INFO(fmt::format("{} {} to {} {}, width {}", line.from.x, line.from.y, line.to.x, line.to.y, line.width));
    CHECK(error(line, window) <= bound(line));
    CHECK(!image(line, window).empty());
  }
}

TEST_CASE("a line's pixels are the same to the bit whatever they are clipped to") {
  hard::Chance random(4);
  for (int k = 0; k < 200; ++k) {
    const auto at = [&] { return random.between(-20, 60); };
    const LineCurve line{
        1, {}, {at(), at()}, {at(), at()}, random.between(0.1, 8), k % 2 == 0 ? Cap::butt : Cap::square};
    const Image whole = image(line, {0, 0, 40, 40});
    Image parts;
    for (int y = 0; y < 40; y += 8) {
      for (int x = 0; x < 40; x += 5) parts.merge(image(line, {x, y, 5, 8}));
    }
    CHECK(whole == parts);
  }
}

TEST_CASE("lines without length or width have no area but for square caps, and enormous ones have finite areas") {
  const PixelArea clip{0, 0, 8, 8};
  CHECK(image({1, {}, {3, 3}, {3, 3}, 1}, clip).empty());
  CHECK(image({1, {}, {1, 1}, {5, 3}, 0}, clip).empty());
  CHECK(image({1, {}, {3, 3}, {3, 3}, 0, Cap::square}, clip).empty());
  CHECK(image({1, {}, {3.5, 3.5}, {3.5, 3.5}, 1, Cap::square}, clip) == Image{{{3, 3}, 1.0}});
  for (const double far : {1e9, 1e15, 1e100, 1e300}) {
    // Through the picture from beyond all bounds; by symmetry it halves what it covers in part.
    const Image level = image({1, {}, {-far, 3.5}, {far, 3.5}, 1}, clip);
    CHECK(level.size() == 8);
    for (const auto& [pixel, area] : level) CHECK((pixel.second == 3 && area == 1));
    for (const auto& [pixel, area] : image({1, {}, {-far, -far}, {far, far}, 1}, clip)) CHECK(area <= 1);
    CHECK(image({1, {}, {far, far}, {2 * far > 1e300 ? far : 2 * far, far}, 1}, clip).empty());
    // Enormous and wide: all of it.
    const Image wide = image({1, {}, {-far, 0}, {far, 0}, far}, clip);
    CHECK(wide.size() == 64);
    for (const auto& [pixel, area] : wide) CHECK(area == 1);
  }
}

}  // namespace moire::test
