#include "curves_exact.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <span>

#include <fmt/format.h>

#include "exact/curves/annulus.h"
#include "exact/curves/curve_areas.h"
#include "exact/curves/stroke.h"
#include "interleaved.h"
#include "run/speed.h"
#include "run/workers.h"
#include "support/curve_frame.h"

#ifdef MOIRE_HAS_CAIRO
#include <cairo/cairo.h>
#endif

namespace moire::benchmark {

namespace {

constexpr int side = 1024;
constexpr int rounds = 31;

using Canvas = std::vector<std::uint8_t>;  // grey, row by row

// White over what is there.
void blend(std::uint8_t& grey, double area) {
  const auto cover = static_cast<unsigned>(area * 255 + 0.5);
  const unsigned t = (255U - grey) * cover + 128;
  grey = static_cast<std::uint8_t>(grey + ((t + (t >> 8)) >> 8));
}

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x); }

// The kernel of a curve, one after another on one canvas.
class Exact {
 public:
  template <class Put>
  static void areas(const LineCurve& line, Put put) {
    area::Stroke(line).areas({0, 0, side, side}, put);
  }
  template <class Put>
  static void areas(const CircleCurve& circle, Put put) {
    area::Annulus(circle).areas({0, 0, side, side}, put);
  }

  template <class Curve>
  void draw(std::span<const Curve> curves) {
    canvas_.assign(canvas_.size(), 0);
    for (const Curve& curve : curves) {
      areas(curve, [&](int x, int y, double area) { blend(canvas_[index(x, y)], area); });
    }
  }
  int at(int x, int y) const { return canvas_[index(x, y)]; }

 private:
  Canvas canvas_ = Canvas(std::size_t{side} * side);
};

#ifdef MOIRE_HAS_CAIRO
class Cairo {
 public:
  Cairo()
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, side, side), cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy) {}

  template <class Curve>
  void draw(std::span<const Curve> curves) {
    cairo_t* const context = context_.get();
    cairo_set_operator(context, CAIRO_OPERATOR_CLEAR);
    cairo_paint(context);
    cairo_set_operator(context, CAIRO_OPERATOR_OVER);
    cairo_set_source_rgba(context, 1, 1, 1, 1);
    for (const Curve& curve : curves) {
      path(curve);
      cairo_set_line_width(context, curve.width);
      cairo_stroke(context);
    }
    cairo_surface_flush(surface_.get());
  }
  int at(int x, int y) const {
    const int stride = cairo_image_surface_get_stride(surface_.get());
    return cairo_image_surface_get_data(surface_.get())[static_cast<std::ptrdiff_t>(y) * stride + x];
  }

 private:
  void path(const LineCurve& line) {
    cairo_move_to(context_.get(), line.from.x, line.from.y);
    cairo_line_to(context_.get(), line.to.x, line.to.y);
  }
  void path(const CircleCurve& circle) {
    cairo_arc(context_.get(), circle.center.x, circle.center.y, circle.radius, 0, 2 * std::numbers::pi);
  }

  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> context_;
};
#endif

class Random {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_{1};
};

// In the canvas, of width 1.
std::vector<LineCurve> lines(std::size_t count, double length) {
  Random random;
  std::vector<LineCurve> all;
  const auto is_inside = [](Point p) { return p.x > 2 && p.x < side - 2 && p.y > 2 && p.y < side - 2; };
  while (all.size() < count) {
    const double angle = random.between(0, 2 * std::numbers::pi);
    const Point from{random.between(0, side), random.between(0, side)};
    const Point to{from.x + length * std::cos(angle), from.y + length * std::sin(angle)};
    if (is_inside(from) && is_inside(to)) all.push_back({all.size() + 1, {1, 1, 1}, from, to});
  }
  return all;
}

std::vector<CircleCurve> circles(std::size_t count) {
  Random random;
  std::vector<CircleCurve> all;
  for (; all.size() < count;) {
    const double radius = random.between(5, 300), margin = radius + 2;
    const Point center{random.between(margin, side - margin), random.between(margin, side - margin)};
    all.push_back({all.size() + 1, {1, 1, 1}, center, radius});
  }
  return all;
}

// Of curves each alone on the canvas, over the pixels that they touch: the root of the mean square, and the largest.
template <class Curve, class Painter>
std::pair<double, double> error(std::span<const Curve> curves, Painter& painter) {
  double squares = 0, largest = 0;
  std::size_t pixels = 0;
  std::vector<double> exact(std::size_t{side} * side);
  for (const Curve& curve : curves) {
    exact.assign(exact.size(), 0);
    Exact::areas(curve, [&](int x, int y, double area) { exact[index(x, y)] = area; });
    painter.draw(std::span(&curve, 1));
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double off = std::abs(painter.at(x, y) - 255 * exact[index(x, y)]);
        if (off == 0 && exact[index(x, y)] == 0) continue;
        squares += off * off, largest = std::max(largest, off);
        ++pixels;
      }
    }
  }
  return {std::sqrt(squares / static_cast<double>(pixels)), largest};
}

template <class Curve>
void against_cairo(const char* what, const std::vector<Curve>& curves) {
  Exact exact;
  const std::span<const Curve> all(curves), few = all.first(40);
  std::vector<Work> works{{"exact", [&] { exact.draw(all); }}};
#ifdef MOIRE_HAS_CAIRO
  Cairo cairo;
  works.push_back({"Cairo", [&] { cairo.draw(all); }});
#endif
  const auto t = interleaved(works, rounds);
  const auto ns = [&](const Timing& timing) {
    return 1e6 * quantile(timing.ms, 0.1) / static_cast<double>(all.size());
  };
  const auto show = [&](const std::string& name, const Timing& timing, std::pair<double, double> off) {
    fmt::print("  {:<22}{:<8}{:10.0f} ns each   error {:5.2f} levels, at the most {:.2f}\n", what, name, ns(timing),
               off.first, off.second);
  };
  show("exact", t[0], error(few, exact));
#ifdef MOIRE_HAS_CAIRO
  show("Cairo", t[1], error(few, cairo));
  fmt::print("  {:<22}exact over Cairo {:.3f} (goal <= 0.2)\n", what, ns(t[0]) / ns(t[1]));
#endif
}

// Whole frames, with all that overlaps.
template <class Given>
void frame(const char* what, const std::vector<Given>& given) {
  const test::CurveFrame scene({side, side}, std::vector<test::Curve>(given.begin(), given.end()));
  const Workers one(1);
  const auto t = interleaved({{"frame",
                               [&] {
                                 const area::CurveAreas areas(scene);
                                 one.render(areas, scene, false, [](std::size_t, const PixelBlock&) {});
                               }}},
                             3);
  fmt::print("  {:<22}a frame of {} in {:.0f} ms\n", what, given.size(), t[0].median());
}

}  // namespace

void run_curves_exact() {
  fmt::print(
      "Exact areas of curves of width 1: {} x {} pixels of grey, blended; the faster tenth of {} rounds, one thread.\n",
      side, side, rounds);
  const auto long_lines = lines(10000, 200), short_lines = lines(10000, 20);
  const auto all_circles = circles(1000);
  against_cairo("lines of 200 px", long_lines);
  against_cairo("lines of 20 px", short_lines);
  against_cairo("circles of 5 .. 300 px", all_circles);
  fmt::print("Whole frames of the sampler, one thread.\n");
  frame("lines of 200 px", long_lines);
  frame("lines of 20 px", short_lines);
  frame("circles of 5 .. 300 px", all_circles);
}

}  // namespace moire::benchmark
