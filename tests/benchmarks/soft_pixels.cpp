#include "soft_pixels.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "interleaved.h"
#include "pixels/pixel_averages.h"
#include "seeing/shadow_frame.h"
#include "shadows.h"
#include "support/soft_scenes.h"

namespace moire::benchmark {

namespace {

using namespace shadow_planes;

constexpr int side = 512, lights = 1024, rounds = 5;
constexpr double extent = 6;  // of the receiver

// cells[i] += height^2 / r^4, r the distance from a point of the light to a cell of a row.
[[gnu::target("avx2")]] void add_kernel(float x0, float step, float square, float power, int begin, int end,
                                        float* cells) {
  for (int i = begin; i < end; ++i) {
    const float x = x0 + step * static_cast<float>(i), r2 = square + x * x;
    cells[i] += power / (r2 * r2);
  }
}

// Mean irradiance at cell middles from points of the light, hidden where their hard shadows lie, row by row in floats:
// what is left of Heckbert and Herf's averaging (1997) if shadows cover a cell or do not, a caster is convex and
// between light and receiver, and the light is parallel to it. No method of ours; below it no averaging is likely to
// get.
class LeanHardShadows {
 public:
  explicit LeanHardShadows(const World& world) : world_(world), cells_(side * side), spans_(side) {}

  void run() {
    std::fill(cells_.begin(), cells_.end(), 0.0F);
    const Convex& light = world_.light.parts[0];
    const Vector u = light[1] - light[0], v = light[3] - light[0];
    const double area = length(u) * length(v);
    for (int k = 0; k < lights; ++k) {
      // A lattice of the golden ratio.
      const double s = (k + 0.5) / lights, t = std::fmod(k * (std::numbers::phi - 1), 1.0);
      add(light[0] + s * u + t * v, area / lights);
    }
  }

 private:
  void add(Vector light, double area) {
    for (auto& spans : spans_) spans.clear();
    for (std::size_t k = 1; k < world_.faces.size(); ++k) {
      const Convex& caster = world_.faces[k].parts[0];
      // In cells.
      outline_.clear();
      for (const Vector& p : caster) {
        const double far = light.z / (light.z - p.z);
        const auto cell = [](double at) { return (at / extent + 0.5) * side; };
        outline_.push_back({cell(light.x + far * (p.x - light.x)), cell(light.y + far * (p.y - light.y))});
      }
      double top = side, bottom = 0;
      for (const Point& p : outline_) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
      const auto first_middle = [](double at) {
        return static_cast<int>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(side)));
      };
      for (int row = first_middle(top); row < first_middle(bottom); ++row) {
        double low = side, high = 0;
        const double y = row + 0.5;
        for (std::size_t c = 0; c < outline_.size(); ++c) {
          const Point &p = outline_[c], &q = outline_[(c + 1) % outline_.size()];
          if ((p.y <= y) == (q.y <= y)) continue;
          const double x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
          low = std::min(low, x), high = std::max(high, x);
        }
        if (first_middle(low) < first_middle(high)) {
          spans_[static_cast<std::size_t>(row)].push_back({first_middle(low), first_middle(high)});
        }
      }
    }
    const double step = extent / side, height = light.z;
    for (int row = 0; row < side; ++row) {
      auto& spans = spans_[static_cast<std::size_t>(row)];
      std::sort(spans.begin(), spans.end(), [](const Span& p, const Span& q) { return p.begin < q.begin; });
      const double y = (row + 0.5) * step - extent / 2 - light.y;
      const auto square = static_cast<float>(height * height + y * y),
                 power = static_cast<float>(area * height * height);
      const auto x0 = static_cast<float>(0.5 * step - extent / 2 - light.x);
      int from = 0;
      for (const Span& span : spans) {
        if (span.begin > from) add_kernel(x0, static_cast<float>(step), square, power, from, span.begin, row_of(row));
        from = std::max(from, span.end);
      }
      add_kernel(x0, static_cast<float>(step), square, power, from, side, row_of(row));
    }
  }
  float* row_of(int row) { return cells_.data() + row * side; }

  struct Span {
    int begin, end;
  };
  const World& world_;
  std::vector<float> cells_;
  std::vector<std::vector<Span>> spans_;
  Outline outline_;
};

struct Errors {
  double largest = 0, rms = 0;
};

Errors errors(const PixelBlock& block, const PixelBlock& truth) {
  Errors result;
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    const double error = std::abs(block.sum(slot).r - truth.sum(slot).r);
    result.largest = std::max(result.largest, error);
    result.rms += error * error;
  }
  result.rms = std::sqrt(result.rms / static_cast<double>(block.slots()));
  return result;
}

}  // namespace

void run_soft_pixels() {
  fmt::print(
      "Exact soft shadows, {} x {} pixels over the receiver, one thread, medians of {} rounds; preparation included.\n"
      "Errors against a tolerance of 1e-9, of a radiance of 1 under the light. Beside them {} hard shadows by area on "
      "a "
      "map\nof as many cells, as heckbert_herf averages them, and a bare loop that asks only whether middles of cells "
      "are "
      "hidden.\nAims: an error of 1e-6, over hard shadows by area 1 with up to three apart and 2.5 with eight slats.\n",
      side, side, rounds, lights);
  const std::vector<LightPoint> points = lattice(lights);
  for (const auto& [name, world] : test::soft_scenes()) {
    const Camera camera = test::overhead({side, side});
    World receiver = world;
    receiver.faces.resize(1);
    const VisibleParts visible(receiver, camera);
    PixelBlock block({0, 0, side, side}, false);
    double bound = 0;
    const auto render = [&, &shadows = world](double tolerance) {
      block.move_to(block);
      bound = PixelAverages(shadows, camera, visible, {tolerance, false}).integrate(nullptr, block);
    };
    const ShadowFrame frame(world, std::make_shared<const Bsp>(world), camera, {});
    LeanHardShadows lean(world);
    const auto t = interleaved({{"exact", [&] { render(PixelAverages::Options{}.tolerance); }},
                                {"by area",
                                 [&] {
                                   IrradianceMap map{side, side, std::vector<float>(std::size_t{side} * side)};
                                   frame.receivers()->add_hard_shadows(0, points, ShadowEdges::by_area, map);
                                 }},
                                {"lean", [&] { lean.run(); }}},
                               rounds);
    render(PixelAverages::Options{}.tolerance);
    const PixelBlock exact = block;
    const double estimated = bound;
    render(1e-9);
    const Errors error = errors(exact, block);
    const double pixels = static_cast<double>(side) * side;
    fmt::print("  {:<26} {:7.1f} ms, {:.2f} points a pixel, error {:.1e} at most (bound {:.1e}), {:.1e} rms\n", name,
               t[0].median(), static_cast<double>(exact.counters.queries) / pixels, error.largest, estimated,
               error.rms);
    for (const std::size_t k : {1U, 2U}) {
      const Ratio over_hard = ratio(t[0], t[k]);
      fmt::print("    {:<24} {:7.1f} ms, {:.2f} ns a pixel and shadow; exact over them {:.2f} ({:.2f} .. {:.2f})\n",
                 k == 1 ? "hard shadows by area" : "bare loop, by middles", t[k].median(),
                 1e6 * t[k].median() / (pixels * lights), over_hard.median, over_hard.low, over_hard.high);
    }
  }
}

}  // namespace moire::benchmark
