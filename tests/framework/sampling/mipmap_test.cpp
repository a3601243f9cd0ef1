// Mip-maps against an independent reading of the same pyramid in doubles, and against the texels of level 0 that the
// fragments name.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "framework/sampling/looked_up.h"

namespace moire::test {
namespace {

using Rgb = std::array<double, 3>;

constexpr std::pair<int, int> sizes[] = {{64, 64}, {1, 1}, {1, 13}, {37, 1}, {100, 37}, {127, 63}};
constexpr Wrap wraps[] = {Wrap::mirror, Wrap::repeat, Wrap::clamp};
constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

// A level at a place, by weights of texels whose indices are wrapped one by one.
Rgb level_at(const Texture& texture, int l, double s, double t, bool is_bilinear) {
  const Pyramid::Level& level = texture.pyramid().level(l);
  if (texture.wrap() == Wrap::clamp) {
    s = std::clamp<double>(s, 0, texture.level(0).width);
    t = std::clamp<double>(t, 0, texture.level(0).height);
  }
  s = s * level.width / texture.level(0).width;
  t = t * level.height / texture.level(0).height;
  Rgb sum{};
  const auto add = [&](double i, double j, double weight) {
    const auto column = wrapped(static_cast<std::int64_t>(i), level.width, texture.wrap());
    const auto row = wrapped(static_cast<std::int64_t>(j), level.height, texture.wrap());
    const float* texel = level.rgba.data() + 4 * (row * level.width + column);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(texel[c]);
  };
  if (!is_bilinear) {
    add(std::floor(s), std::floor(t), 1);
    return sum;
  }
  for (double j = std::floor(t - 0.5); j < t + 0.5; ++j) {
    for (double i = std::floor(s - 0.5); i < s + 0.5; ++i) {
      add(i, j, std::max(0.0, 1 - std::abs(s - 0.5 - i)) * std::max(0.0, 1 - std::abs(t - 0.5 - j)));
    }
  }
  return sum;
}

double asked_level(const SurfacePoint& p, const std::string& side) {
  const double across = std::hypot(p.ds_dx, p.dt_dx), down = std::hypot(p.ds_dy, p.dt_dy);
  const double determinant = static_cast<double>(p.ds_dx) * static_cast<double>(p.dt_dy) -
                             static_cast<double>(p.dt_dx) * static_cast<double>(p.ds_dy);
  const double length = side == "max"   ? std::max(across, down)
                        : side == "min" ? std::min(across, down)
                                        : std::sqrt(std::abs(determinant));
  return std::log2(std::max(1.0, length));
}

double farthest(Color a, const Rgb& b) {
  return std::max({std::abs(static_cast<double>(a.r) - b[0]), std::abs(static_cast<double>(a.g) - b[1]),
                   std::abs(static_cast<double>(a.b) - b[2])});
}

bool same_bits(const LookedUp& a, const LookedUp& b) { return a.sum == b.sum; }

Rgb color_of_fragments(const LookedUp& found) {
  Rgb sum{};
  for (const Fragment& f : found.fragments) {
    sum[0] += f.weight * static_cast<double>(f.color.r);
    sum[1] += f.weight * static_cast<double>(f.color.g);
    sum[2] += f.weight * static_cast<double>(f.color.b);
  }
  for (double& c : sum) c /= found.sum.weight;
  return sum;
}

double weight_of_fragments(const LookedUp& found) {
  double sum = 0;
  for (const Fragment& f : found.fragments) sum += f.weight;
  return sum;
}

}  // namespace

// Values lie in 0 .. 1. An interpolation a + f (b - a) rounds three times to floats, by 2^-25 at most each, and f once,
// by 2^-25; three are nested (seven in all, of which no path meets more), then the colour is a float: (3 * 4 + 1)
// 2^-25. The level is right to 1e-7, and the places of texels to 2^-52 of some thousand texels.
constexpr double float_bound = 13 * 0x1p-25;
constexpr double trilinear_bound = float_bound + 1e-7 + 1e-11;

TEST_CASE("trilinear mip-mapping agrees with the weights of eight texels in doubles") {
  for (const auto& [width, height] : sizes) {
    for (const Wrap wrap : wraps) {
      const NoiseTexture noise(width, height, wrap);
      const int top = noise.texture.pyramid().levels() - 1;
      for (const std::string side : {"max", "min", "area"}) {
        for (const double bias : {0.0, -1.25}) {
          const auto mipmap = lookup("mipmap", {{"level", side}, {"bias", bias}});
          double worst = 0;
          for (int n = 0; n < 300; ++n) {
            const SurfacePoint point = some_place(n, 5 * std::max(width, height));
            const double level = std::clamp<double>(asked_level(point, side) + bias, 0, top);
            const int fine = std::min(static_cast<int>(level), std::max(0, top - 1));
            const Rgb a = level_at(noise.texture, fine, point.s, point.t, true);
            const Rgb b = level_at(noise.texture, std::min(fine + 1, top), point.s, point.t, true);
            Rgb expected;
            for (std::size_t c = 0; c < 3; ++c) expected[c] = a[c] * (1 - (level - fine)) + b[c] * (level - fine);
            worst = std::max(worst, farthest(looked_up(*mipmap, point, noise.texture, false).color(), expected));
          }
          CAPTURE(width, height, static_cast<int>(wrap), side, bias);
          CHECK(worst <= trilinear_bound);
        }
      }
    }
  }
}

TEST_CASE("the nearest level is one level, and the nearest texel of it one texel") {
  for (const auto& [width, height] : sizes) {
    for (const Wrap wrap : wraps) {
      const NoiseTexture noise(width, height, wrap);
      const int top = noise.texture.pyramid().levels() - 1;
      for (const char* within : {"bilinear", "nearest"}) {
        const bool is_bilinear = std::string(within) == "bilinear";
        const auto mipmap = lookup("mipmap", {{"between", std::string("nearest")}, {"within", std::string(within)}});
        double worst = 0;
        for (int n = 0; n < 300; ++n) {
          const SurfacePoint point = some_place(n, 5 * std::max(width, height));
          const double level = std::min<double>(asked_level(point, "max"), top);
          const Rgb expected =
              level_at(noise.texture, static_cast<int>(std::round(level)), point.s, point.t, is_bilinear);
          worst = std::max(worst, farthest(looked_up(*mipmap, point, noise.texture, false).color(), expected));
        }
        CAPTURE(width, height, static_cast<int>(wrap), within);
        CHECK(worst <= (is_bilinear ? float_bound : 0));
      }
    }
  }
}

TEST_CASE("footprints up to one texel are bilinear interpolation") {
  for (const Wrap wrap : wraps) {
    const NoiseTexture noise(13, 7, wrap);
    const auto mipmap = lookup("mipmap"), bilinear = lookup("bilinear");
    // Dyadic places within the texture: both compute the same weights without rounding.
    for (double t = 0.5; t <= 6.5; t += 0.375) {
      for (double s = 0.5; s <= 12.5; s += 0.375) {
        const SurfacePoint point = place(s, t, 0.6F, -0.8F, 0.25F, 0);
        const LookedUp a = looked_up(*mipmap, point, noise.texture), b = looked_up(*bilinear, point, noise.texture);
        REQUIRE(a.fragments.size() == b.fragments.size());
        for (const Fragment& f : b.fragments) {
          REQUIRE(std::any_of(a.fragments.begin(), a.fragments.end(), [&](const Fragment& own) {
            return own.element == f.element && own.weight == f.weight && own.color == f.color;
          }));
        }
      }
    }
  }
}

// What differs: the pyramid's texels are floats (2^-25 each, of convex weights), and the lookup's own roundings.
TEST_CASE("fragments name base texels that sum to the weight and average to the colour") {
  for (const auto& [width, height] : sizes) {
    for (const Wrap wrap : wraps) {
      const NoiseTexture noise(width, height, wrap);
      for (const char* name : {"mipmap", "anisotropic"}) {
        const auto own = lookup(name);
        double worst_weight = 0, worst_color = 0;
        bool are_distinct = true, are_named_alike = true;
        for (int n = 0; n < 100; ++n) {
          const double weight = 0.25 + n;
          const LookedUp found =
              looked_up(*own, some_place(n, 5 * std::max(width, height)), noise.texture, true, weight);
          worst_weight = std::max(worst_weight, std::abs(weight_of_fragments(found) / weight - 1));
          worst_color = std::max(worst_color, farthest(found.color(), color_of_fragments(found)));
          std::set<Element> elements;
          for (const Fragment& f : found.fragments) {
            are_distinct = are_distinct && elements.insert(f.element).second && f.weight > 0;
            const TexelIndex index = texel_index(f.element);
            are_named_alike =
                are_named_alike && (index.level > 0 || noise.texture.texel(0, index.i, index.j).color == f.color);
          }
        }
        CAPTURE(width, height, static_cast<int>(wrap), name);
        CHECK(are_distinct);
        CHECK(are_named_alike);
        CHECK(worst_weight <= 1e-12);
        // Anisotropic: up to 64 differences summed in floats more; here 16, of at most 1, divided by their number.
        CHECK(worst_color <= float_bound + 0x1p-25 + (name == std::string("mipmap") ? 0 : 17 * 0x1p-24));
      }
    }
  }
}

TEST_CASE("recording changes no bit of what is seen") {
  const NoiseTexture noise(100, 37, Wrap::mirror);
  for (const char* name : {"mipmap", "anisotropic"}) {
    for (int n = 0; n < 200; ++n) {
      const SurfacePoint point = some_place(n, 1000);
      REQUIRE(same_bits(looked_up(*lookup(name), point, noise.texture, true, 0.3),
                        looked_up(*lookup(name), point, noise.texture, false, 0.3)));
    }
  }
}

TEST_CASE("base texels are those that a level's texels cover, whole or in part, without wrapping") {
  // 5 x 1 texels; level 1 has 2, each over 2.5 of them. On the border between two copies both have half.
  const NoiseTexture noise(5, 1, Wrap::repeat);
  const auto mipmap = lookup("mipmap", {{"between", std::string("nearest")}});
  for (const std::int64_t copy : {-3, 0, 7}) {
    const LookedUp found = looked_up(*mipmap, place(5.0 * static_cast<double>(copy), 0.5, 2), noise.texture);
    std::map<std::int64_t, double> weights;
    for (const Fragment& f : found.fragments) weights[texel_index(f.element).i - 5 * copy] = f.weight;
    REQUIRE(weights.size() == 6);
    for (const auto& [texel, share] : {std::pair{-3, 0.1}, {-2, 0.2}, {-1, 0.2}, {0, 0.2}, {1, 0.2}, {2, 0.1}}) {
      CHECK(std::abs(weights.at(texel) - share) <= 1e-15);
    }
  }
}

TEST_CASE("a mirrored copy's texels run backwards") {
  const NoiseTexture noise(4, 1, Wrap::mirror);
  // In the middle of texel 5, which shows texel 2.
  const LookedUp found = looked_up(*lookup("mipmap"), place(5.5, 0.5), noise.texture);
  REQUIRE(found.fragments.size() == 1);
  CHECK(found.fragments[0].element == texel_element(0, 5, 0));
  CHECK(found.color() == noise.texture.texel(0, 2, 0).color);
  // Level 1 of the copy to the left, -4 .. 0, mirrored; its texel -4 .. -2 covers texels that show 3 and 2.
  const LookedUp coarse = looked_up(*lookup("mipmap"), place(-3, 0.5, 2), noise.texture);
  REQUIRE(coarse.fragments.size() == 2);
  CHECK(coarse.fragments[0].element == texel_element(0, -4, 0));
  CHECK(coarse.fragments[1].element == texel_element(0, -3, 0));
}

TEST_CASE("texels that average more base texels than are named stand for themselves") {
  const NoiseTexture noise(64, 64, Wrap::repeat);
  const auto mipmap = lookup("mipmap", {{"between", std::string("nearest")}});
  // In the middle of a texel: of level 4, of 256 texels; of level 5, of 1024.
  const LookedUp fine = looked_up(*mipmap, place(64 + 8, 8, 16), noise.texture);
  CHECK(fine.fragments.size() == 256);
  const LookedUp coarse = looked_up(*mipmap, place(64 + 16, 16, 32), noise.texture);
  REQUIRE(coarse.fragments.size() == 1);
  CHECK(coarse.fragments[0].element == texel_element(5, 2, 0));
  CHECK(coarse.fragments[0].color == coarse.color());
  CHECK(coarse.fragments[0].weight == 1);
}

TEST_CASE("far from the origin the same place of another copy has the same bits") {
  for (const Wrap wrap : {Wrap::mirror, Wrap::repeat}) {
    const NoiseTexture noise(100, 37, wrap);
    const double periods = wrap == Wrap::mirror ? 2 : 1;
    for (const char* name : {"mipmap", "anisotropic"}) {
      const auto own = lookup(name);
      for (int n = 0; n < 200; ++n) {
        SurfacePoint near = some_place(n, 400);
        near.s = std::round(near.s * 1024) / 1024;  // exact however far out it is moved
        near.t = std::round(near.t * 1024) / 1024;
        // So are the ways of anisotropic's reads.
        for (float* way : {&near.ds_dx, &near.dt_dx, &near.ds_dy, &near.dt_dy}) *way = std::round(*way * 16) / 16;
        SurfacePoint far = near;
        far.s += periods * 100 * 8e5 * n;
        far.t -= periods * 37 * 1e6;
        const LookedUp a = looked_up(*own, near, noise.texture, false), b = looked_up(*own, far, noise.texture, false);
        // Reads that lie in thirds of a derivative are rounded where they are: to 1e-6 texels this far out.
        if (std::string(name) == "mipmap") REQUIRE(same_bits(a, b));
        REQUIRE(farthest(a.color(), {b.sum.r, b.sum.g, b.sum.b}) <= 1e-5);
      }
    }
  }
}

TEST_CASE("however far a place is, its colour is one of the texture's") {
  for (const Wrap wrap : wraps) {
    const NoiseTexture noise(100, 37, wrap);
    for (const char* name : {"mipmap", "anisotropic", "oiio"}) {
      for (const double far : {1e15, -1e18, 1e300, -1e300}) {
        const Color color = looked_up(*lookup(name), place(far, -far, 3, 1, 1, 2), noise.texture).color();
        CHECK((color.r >= 0 && color.r <= 1));
      }
    }
  }
}

TEST_CASE("a place that is none has a colour that is no number, and the element that the scene sees") {
  const NoiseTexture noise(8, 8, Wrap::repeat);
  for (const char* name : {"mipmap", "anisotropic", "oiio"}) {
    for (const double nowhere : {static_cast<double>(nan), static_cast<double>(infinity)}) {
      SurfacePoint point = place(nowhere, 1);
      point.hit.element = 42;
      const LookedUp found = looked_up(*lookup(name), point, noise.texture, true, 0.5);
      REQUIRE(found.fragments.size() == 1);
      CHECK(found.fragments[0].element == 42);
      CHECK(found.sum.weight == 0.5);
      CHECK(std::isnan(found.color().g));
    }
  }
}

TEST_CASE("no footprint is the texel, and one that nobody knows is the whole texture") {
  const NoiseTexture noise(100, 37, Wrap::repeat);
  const Pyramid& pyramid = noise.texture.pyramid();
  const float* mean = pyramid.level(pyramid.levels() - 1).rgba.data();
  for (const char* name : {"mipmap", "anisotropic"}) {
    CHECK(looked_up(*lookup(name), place(3.5, 4.5), noise.texture).color() == noise.texture.texel(0, 3, 4).color);
    for (const float unknown : {nan, infinity, -infinity}) {
      CHECK(looked_up(*lookup(name), place(3.5, 4.5, unknown, 1, 1, 1), noise.texture).color() ==
            Color{mean[0], mean[1], mean[2]});
      CHECK(looked_up(*lookup(name), place(3.5, 4.5, 1, 1, 1, unknown), noise.texture).color() ==
            Color{mean[0], mean[1], mean[2]});
    }
  }
}

TEST_CASE("a texel that is no number shows where it is read and nowhere else") {
  NoiseTexture noise(64, 64, Wrap::repeat);
  noise.rgb[3 * (20 * 64 + 10)] = nan;
  for (const char* name : {"mipmap", "anisotropic", "oiio"}) {
    const auto own = lookup(name);
    CHECK(std::isnan(looked_up(*own, place(10.5, 20.5), noise.texture).color().r));
    CHECK(std::isnan(looked_up(*own, place(13.5, 21.5, 8, 0, 0, 8), noise.texture).color().r));
    CHECK(std::isfinite(looked_up(*own, place(40.5, 40.5), noise.texture).color().r));
    CHECK(std::isfinite(looked_up(*own, place(10.5, 20.5), noise.texture).color().g));
  }
}

TEST_CASE("a texture of one colour stays that colour, bit for bit") {
  for (const auto& [width, height] : {std::pair{1023, 511}, {1, 1}, {1, 100}}) {
    NoiseTexture constant(width, height, Wrap::mirror);
    for (std::size_t k = 0; k < constant.rgb.size(); ++k) constant.rgb[k] = k % 3 == 0 ? 0.1F : 1.0F / 3;
    for (const char* name : {"mipmap", "anisotropic"}) {
      for (int n = 0; n < 200; ++n) {
        REQUIRE(looked_up(*lookup(name), some_place(n, 5000), constant.texture, false).color() ==
                Color{0.1F, 1.0F / 3, 1.0F / 3});
      }
    }
  }
}

TEST_CASE("the level that the scene shows does not change what mip-maps read") {
  const NoiseTexture noise(64, 64, Wrap::repeat);
  for (const char* name : {"mipmap", "anisotropic"}) {
    SurfacePoint point = place(10.3, 20.7, 5, 1, 1, 3);
    const LookedUp found = looked_up(*lookup(name), point, noise.texture);
    point.level = 3;
    CHECK(same_bits(found, looked_up(*lookup(name), point, noise.texture)));
  }
}

TEST_CASE("the footprint asked for is the lookup's") {
  for (const char* name : {"mipmap", "anisotropic", "oiio"}) {
    CHECK(lookup(name)->footprint() == Footprint::sample);
    CHECK(lookup(name, {{"footprint", std::string("pixel")}})->footprint() == Footprint::pixel);
  }
}

}  // namespace moire::test
