#include "curves.h"

#include <numbers>
#include <random>

#include <fmt/format.h>

#include "circles/gupta_sproull.h"
#include "circles/midpoint.h"
#include "circles/two_point.h"
#include "interleaved.h"
#include "lines/gupta_sproull.h"
#include "lines/two_point.h"
#include "run/speed.h"

namespace moire::benchmark {

namespace {

using namespace scan_conversion;

constexpr int rounds = 40;

// Uniform numbers in [0, 1).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

// The time that few rounds beat.
double low(const Timing& timing) { return quantile(timing.ms, 0.1); }

template <std::uint32_t full, class Draw>
Work drawn(const std::string& name, GreyCanvas& canvas, bool blended, Draw draw) {
  return {name, [&canvas, blended, draw] {
            blended ? draw(GreyCanvas::Put<full, true>(canvas)) : draw(GreyCanvas::Put<full, false>(canvas));
          }};
}

// All lines by one method.
template <std::uint32_t full, class Line>
Work lines_by(const std::string& name, GreyCanvas& canvas, bool blended, const std::vector<PixelLine>& lines,
              Line line) {
  return drawn<full>(name, canvas, blended, [&lines, line](auto put) {
    for (const auto& [from, to] : lines) line(from, to, put);
  });
}

void compare_lines(GreyCanvas& canvas, double length) {
  const auto lines = lines_of_length(length, 10000);
  double columns = 0;
  for (const auto& [from, to] : lines) columns += static_cast<double>(octant_of(from, to).columns + 1);
  const auto two_point = [](LineMethod method, bool both_ends) {
    return [how = TwoPointLines{.method = method, .both_ends = both_ends}](PixelIndex from, PixelIndex to, auto put) {
      two_point_line(how, from, to, GreyCanvas::area, put);
    };
  };
  const auto bresenham = [](PixelIndex from, PixelIndex to, auto put) {
    bresenham_line(from, to, GreyCanvas::area, put);
  };
  const auto gupta_sproull = [](PixelIndex from, PixelIndex to, auto put) {
    gupta_sproull_line(from, to, GreyCanvas::area, put);
  };
  for (const bool blended : {false, true}) {
    const auto timings = interleaved(
        {lines_by<255>("accumulator", canvas, blended, lines, two_point(LineMethod::accumulator, true)),
         lines_by<255>("direct, double", canvas, blended, lines, two_point(LineMethod::direct, false)),
         lines_by<255>("accumulator, one end", canvas, blended, lines, two_point(LineMethod::accumulator, false)),
         lines_by<255>("direct, double, both ends", canvas, blended, lines, two_point(LineMethod::direct, true)),
         lines_by<255>("Fujimoto-Iwata", canvas, blended, lines, two_point(LineMethod::fujimoto_iwata, false)),
         lines_by<1>("Bresenham", canvas, blended, lines, bresenham),
         lines_by<255>("Gupta-Sproull", canvas, blended, lines, gupta_sproull)},
        rounds);
    const char* const names[] = {
        "accumulator",    "direct, double", "accumulator, one end", "direct, double, both ends",
        "Fujimoto-Iwata", "Bresenham",      "Gupta-Sproull"};
    fmt::print("  lines of {} pixels, {:.1f} columns each, {}\n", length, columns / static_cast<double>(lines.size()),
               blended ? "blended" : "stored");
    for (std::size_t k = 0; k < timings.size(); ++k) {
      const double ms = low(timings[k]);
      fmt::print("    {:<28}{:6.2f} ns a column {:8.0f} ns a line\n", names[k], 1e6 * ms / columns,
                 1e6 * ms / static_cast<double>(lines.size()));
    }
    const Ratio both = ratio(timings[0], timings[1]);
    fmt::print("    accumulator over direct      {:6.2f}  ({:.2f} .. {:.2f})   <= 0.65\n",
               low(timings[0]) / low(timings[1]), both.low, both.high);
  }
}

// Middles of pixels and radii from 5 to 300, within the canvas.
std::vector<PixelCircle> circles(int count) {
  std::vector<PixelCircle> result;
  Uniform random(2);
  for (int k = 0; k < count; ++k) {
    const auto radius = static_cast<std::int64_t>(5 + random() * 296);
    const double room = static_cast<double>(GreyCanvas::side - 2 * radius - 4);
    const auto place = [&] { return radius + 2 + static_cast<std::int64_t>(random() * room); };
    const std::int64_t x = place();
    result.push_back({{x, place()}, radius});
  }
  return result;
}

void compare_circles(GreyCanvas& canvas) {
  const auto all = circles(1000);
  std::vector<RootTable> tables;
  double rows = 0;
  for (std::int64_t radius = 0; radius <= 300; ++radius) tables.emplace_back(std::max<std::int64_t>(radius, 3), 8);
  for (const PixelCircle& circle : all) rows += 8 * static_cast<double>(circle.last_row() + 1);
  const auto by = [&](auto draw) {
    return [&all, draw](auto put) {
      for (const PixelCircle& circle : all) draw(circle, put);
    };
  };
  const auto midpoint = by([](const PixelCircle& circle, auto put) { midpoint_circle(circle, GreyCanvas::area, put); });
  const auto root = by([](const PixelCircle& circle, auto put) {
    two_point_circle(circle, RootBand(circle.radius, 8), 255, GreyCanvas::area, put);
  });
  const auto table = by([&tables](const PixelCircle& circle, auto put) {
    const RootTable& own = tables[static_cast<std::size_t>(circle.radius)];
    two_point_circle(circle, TableBand<true>(own, 8), 255, GreyCanvas::area, put);
  });
  const auto cone =
      by([](const PixelCircle& circle, auto put) { gupta_sproull_circle(circle, GreyCanvas::area, put); });
  for (const bool blended : {false, true}) {
    const std::vector<Work> works{drawn<255>("two points by roots", canvas, blended, root),
                                  drawn<255>("two points by a table", canvas, blended, table),
                                  drawn<1>("midpoint", canvas, blended, midpoint),
                                  drawn<255>("Gupta-Sproull", canvas, blended, cone)};
    const auto timings = interleaved(works, rounds);
    fmt::print("  circles of radius 5 to 300, {:.0f} rows of octants each, {}\n",
               rows / static_cast<double>(all.size()), blended ? "blended" : "stored");
    for (std::size_t k = 0; k < works.size(); ++k) {
      fmt::print("    {:<28}{:6.2f} ns a row    {:8.2f} us a circle\n", works[k].name, 1e6 * low(timings[k]) / rows,
                 1e3 * low(timings[k]) / static_cast<double>(all.size()));
    }
    fmt::print("    roots over table             {:6.2f}   <= 1.1\n", low(timings[0]) / low(timings[1]));
  }
}

}  // namespace

std::vector<PixelLine> lines_of_length(double length, int count) {
  std::vector<PixelLine> result;
  Uniform random(1);
  const auto pixel = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  while (result.size() < static_cast<std::size_t>(count)) {
    const double angle = 2 * std::numbers::pi * random();
    const double x = GreyCanvas::side * random(), y = GreyCanvas::side * random();
    const PixelLine line{{pixel(x), pixel(y)},
                         {pixel(x + length * std::cos(angle)), pixel(y + length * std::sin(angle))}};
    // Room for the pixels beside it.
    const PixelArea inner{2, 2, GreyCanvas::side - 4, GreyCanvas::side - 4};
    if (holds(inner, line.from.x, line.from.y) && holds(inner, line.to.x, line.to.y)) result.push_back(line);
  }
  return result;
}

void run_curves() {
  fmt::print("Lines and circles on 1024 x 1024 pixels of 8 bits: the 10th percentile of {} rounds in turn.\n", rounds);
  GreyCanvas canvas;
  compare_lines(canvas, 200);
  compare_lines(canvas, 20);
  compare_circles(canvas);
}

}  // namespace moire::benchmark
