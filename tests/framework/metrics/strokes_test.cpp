// Strokes of pictures whose ink is written down.
#include <cmath>
#include <functional>
#include <numbers>

#include "framework/metrics/measured.h"
#include "metrics/registry.h"
#include "support/curve_frame.h"

namespace moire::test {

namespace {

constexpr ImageSize size{96, 64};
constexpr Color paper{1, 1, 1};

// Paper less as much ink as is given for each pixel, in all channels.
Picture inked(const std::function<double(int, int)>& ink) {
  Picture picture{size, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto light = static_cast<float>(1 - ink(x, y));
      picture.pixels.push_back({light, light, light});
    }
  }
  return picture;
}

std::map<std::string, double> strokes(const std::vector<Curve>& curves, const Picture& picture,
                                      const Picture& reference, double blur = 1) {
  Settings settings(strokes_description.parameters);
  settings.set("blur", blur);
  const CurveFrame frame(size, curves, paper);
  std::map<std::string, double> values;
  for (const Measurement& m : make_strokes(settings)->finish({picture, reference, {}, &frame}))
    values[std::string(m.quantity)] = m.value;
  return values;
}

// Along the middles of the pixels of row 30.
Curve level() { return LineCurve{1, {}, {4, 30.5}, {92, 30.5}}; }

}  // namespace

TEST_CASE("ink is counted against the reference's") {
  const Picture full = inked([](int, int y) { return y == 30 ? 0.5 : 0; });
  const Picture half = inked([](int, int y) { return y == 30 ? 0.25 : 0; });
  auto found = strokes({level()}, half, full);
  CHECK(std::abs(found.at("strokes.energy") - 0.5) < 1e-6);
  CHECK(std::abs(found.at("strokes.rmse") - 0.5) < 1e-6);
  CHECK(found.at("strokes.ripple") < 1e-6);
  found = strokes({level()}, full, full);
  CHECK(found.at("strokes.energy") == 1);
  CHECK(found.at("strokes.rmse") == 0);
}

TEST_CASE("a wave of ink along a line ripples as much as the blur leaves of it") {
  // 1/2 + 1/4 cos(2 pi x / P): of the wave a Gaussian leaves exp(-2 pi^2 d^2 / P^2). It is sampled once a pixel, whose
  // Gaussian sum at deviation 1 equals the integral within 2 exp(-2 pi^2) = 5e-9; floats err by 1e-7. The farthest
  // places of a quarter pixel's steps miss a crest by 1/8 pixel: 1 - cos(2 pi / (8 P)).
  constexpr double period = 8;
  const auto wave = [](int x, int) { return 0.5 + 0.25 * std::cos(2 * std::numbers::pi * (x + 0.5) / period); };
  for (const double blur : {1.0, 2.0}) {
    const double left = std::exp(-2 * std::pow(std::numbers::pi * blur / period, 2));
    const auto found = strokes({level()}, inked(wave), inked(wave), blur);
    const double missed = 1 - std::cos(2 * std::numbers::pi / (8 * period));
    // The mean is taken over 72 pixels, nine periods; its two ends are both counted.
    CHECK(std::abs(found.at("strokes.ripple") - left) < left * (missed + 0.01) + 1e-6);
  }
}

TEST_CASE("a circle's ripple is looked for all around it, a mean over all strokes is reported with its ends") {
  // Ink that falls from left to right: 1 - x / 96, of which a circle of radius 20 about x = 48 meets 28/96 .. 68/96.
  const Picture ramp = inked([](int x, int) { return 1 - (x + 0.5) / size.width; });
  const Curve circle = CircleCurve{1, {}, {48, 32}, 20, 1};
  CHECK(std::abs(strokes({circle}, ramp, ramp).at("strokes.ripple") - (40.0 / 96) / 0.5) < 1e-3);

  const CurveFrame frame(size, {circle, LineCurve{2, {}, {48.5, 4}, {48.5, 60}}}, paper);
  for (const Measurement& m :
       make_strokes(Settings(strokes_description.parameters))->finish({ramp, ramp, {}, &frame})) {
    if (m.quantity != "strokes.ripple") continue;
    CHECK(m.low < 1e-6);
    CHECK(std::abs(m.high - 0.8333) < 1e-3);
    CHECK(std::abs(m.value - m.high / 2) < 1e-6);
  }
}

TEST_CASE("what has no ink or lies outside the picture has no strokes to speak of") {
  const Picture blank = inked([](int, int) { return 0; });
  CHECK(strokes({level()}, blank, blank).empty());
  CHECK(strokes({LineCurve{1, {}, {-50, -50}, {-5, -20}}}, inked([](int, int) { return 0.5; }), blank).empty());
  // Too short for its ends.
  const Picture dot = inked([](int x, int y) { return x == 40 && y == 30 ? 1 : 0; });
  CHECK(strokes({LineCurve{1, {}, {40, 30.5}, {41, 30.5}}}, dot, dot).count("strokes.ripple") == 0);
}

TEST_CASE("ink that is no number gives no number") {
  const Picture full = inked([](int, int y) { return y == 30 ? 0.5 : 0; });
  const Picture broken = inked([](int x, int y) { return x == 9 && y == 30 ? std::nan("") : y == 30 ? 0.5 : 0; });
  const auto found = strokes({level()}, broken, full);
  CHECK(std::isnan(found.at("strokes.energy")));
  CHECK(std::isnan(found.at("strokes.rmse")));
}

}  // namespace moire::test
