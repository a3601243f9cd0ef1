// Points and places on the texture, held to rays of extended precision and to differences of places.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/textured_plane/compared.h"

namespace moire::test {
namespace {

std::vector<Camera> all_views() {
  std::vector<Camera> views = aligned_views();
  const std::vector<Camera> turned = turned_views();
  views.insert(views.end(), turned.begin(), turned.end());
  return views;
}

SurfacePoint located(const Frame& frame, double x, double y) {
  const SamplePoint point{x, y};
  SurfacePoint result;
  Counters counters;
  frame.surface()->locate(std::span(&point, 1), std::span(&result, 1), counters);
  return result;
}

Hit traced(const Frame& frame, double x, double y) {
  const SamplePoint point{x, y};
  Hit hit;
  Counters counters;
  frame.trace(std::span(&point, 1), std::span(&hit, 1), counters);
  CHECK(counters.queries == 1);
  CHECK(counters.hits == (hit.element != background));
  return hit;
}

// Calls check(camera, frame, x, y) for points of all views, some of them outside the picture.
template <class Check>
void for_each_point(const Texels& texels, Check check) {
  for (const Camera& camera : all_views()) {
    const textured_plane::PlaneFrame frame(camera, texels, {0.2F, 0.4F, 0.8F}, 1e-4);
    for (double y = -1.3; y < camera.size.height + 2; y += 0.71) {
      for (double x = -1.1; x < camera.size.width + 2; x += 0.83) {
        CAPTURE(camera.height, camera.pitch_deg, camera.yaw_deg, camera.roll_deg, x, y);
        check(camera, frame, x, y);
      }
    }
  }
}

}  // namespace

TEST_CASE("a point of the plane sees the texel that its ray meets") {
  const Texels texels = random_texels(7, 5, Wrap::mirror);
  int near = 0, far = 0, sky = 0, unsure = 0;
  for_each_point(texels, [&](const Camera& camera, const Frame& frame, double x, double y) {
    const Hit hit = traced(frame, x, y);
    const Direction3 ray = ray_through(camera, x, y);
    // Rounding is 1e-16 of a ray, and of the distance that it goes.
    const long double length = std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
    if (std::abs(ray.z) < 1e-13L * length) return void(++unsure);
    if (ray.z > 0) {
      ++sky;
      REQUIRE(hit.element == background);
      REQUIRE(hit.color == Color{0.2F, 0.4F, 0.8F});
      return;
    }
    const long double ahead = distance_ahead(camera, ray);
    const long double blur = 1e-13L * camera.height * length * length / (ray.z * ray.z) + 1e-13L;
    if (std::abs(ahead - camera.far) < blur) return void(++unsure);
    if (ahead > camera.far) {
      ++far;
      REQUIRE(hit.element == textured_plane::far_ground);
      REQUIRE(hit.color == texels.mean());
      return;
    }
    const long double s = camera.x + camera.height * ray.x / -ray.z, t = camera.y + camera.height * ray.y / -ray.z;
    const SurfacePoint place = located(frame, x, y);
    REQUIRE(place.textured);
    REQUIRE(std::abs(place.s - s) <= blur);
    REQUIRE(std::abs(place.t - t) <= blur);
    if (std::abs(s - std::round(s)) < blur || std::abs(t - std::round(t)) < blur) return void(++unsure);
    ++near;
    const Hit exact =
        texels.texture().texel(0, static_cast<std::int64_t>(std::floor(s)), static_cast<std::int64_t>(std::floor(t)));
    REQUIRE(hit.element == exact.element);
    REQUIRE(hit.color == exact.color);
  });
  CHECK(near > 5000);
  CHECK(far > 400);
  CHECK(sky > 1000);
  CHECK(unsure < 100);
}

TEST_CASE("a place on the plane shows what tracing sees and moves with the image point as it says") {
  const Texels texels = random_texels(7, 5, Wrap::repeat);
  constexpr double step = 1e-4;
  int compared = 0;
  for_each_point(texels, [&](const Camera& camera, const Frame& frame, double x, double y) {
    const SurfacePoint place = located(frame, x, y);
    const Hit hit = traced(frame, x, y);
    REQUIRE(place.hit.element == hit.element);
    REQUIRE(place.hit.color == hit.color);
    REQUIRE(place.textured == (hit.element != background && hit.element != textured_plane::far_ground));
    if (!place.textured) return;
    REQUIRE(texel_index(hit.element).i == static_cast<std::int64_t>(std::floor(place.s)));
    REQUIRE(texel_index(hit.element).j == static_cast<std::int64_t>(std::floor(place.t)));
    const SurfacePoint left = located(frame, x - step, y), right = located(frame, x + step, y);
    const SurfacePoint above = located(frame, x, y - step), below = located(frame, x, y + step);
    if (!left.textured || !right.textured || !above.textured || !below.textured) return;
    ++compared;
    // The third derivative of 1 / k is 6 / k^4, so that central differences are (step / k)^2 of the derivative off, k
    // the pixels to the horizon; to the far limit they are 0.1 or more in these views. Places have 1e-15 of their size.
    const Direction3 ray = ray_through(camera, x, y);
    const double k = static_cast<double>(-ray.z);
    const auto agrees = [&](const SurfacePoint& before, const SurfacePoint& after, float ds, float dt) {
      const double slope = std::hypot(ds, dt);
      const double size = std::abs(place.s) + std::abs(place.t);
      const double off = slope * (1e-6 + 2 * (step / k) * (step / k)) + 1e-15 * size * (1 + 1 / k) / step;
      return std::abs((after.s - before.s) / (2 * step) - ds) <= off &&
             std::abs((after.t - before.t) / (2 * step) - dt) <= off;
    };
    REQUIRE(agrees(left, right, place.ds_dx, place.dt_dx));
    REQUIRE(agrees(above, below, place.ds_dy, place.dt_dy));
  });
  CHECK(compared > 5000);
}

TEST_CASE("averages of the plane count pixels, and those that are not all sky") {
  const Texels texels = random_texels(7, 5, Wrap::repeat);
  Camera camera{.size = {20, 21}, .height = 2, .far = 100, .fov_deg = 90};
  for (const double yaw : {0.0, 1.0}) {
    camera.yaw_deg = yaw;
    PixelBlock block({0, 0, 20, 21}, false);
    textured_plane::PlaneFrame(camera, texels, {}, 1e-4).averages()->integrate(nullptr, block);
    CHECK(block.counters == Counters{.queries = 20 * 21, .hits = 20 * 11, .steps = 0});
  }
}

// Told without a formula: yaw 0 looks east along rows, and a camera turned clockwise sees the horizon rise to the
// right.
TEST_CASE("directions of the plane's camera") {
  const Texels texels = random_texels(7, 5, Wrap::repeat);
  Camera camera{.size = {20, 20}, .x = 50, .y = 50, .height = 2, .far = 1000, .fov_deg = 90};
  const auto at = [&](double x, double y) {
    return traced(textured_plane::PlaneFrame(camera, texels, {}, 1e-4), x, y).element;
  };
  const auto texel = [&](double x, double y) { return texel_index(at(x, y)); };
  CHECK(texel(10, 19).i > 50);
  CHECK(texel(12, 19).j >= texel(8, 19).j);
  camera.yaw_deg = 90;
  CHECK(texel(10, 19).j > 50);
  CHECK(texel(12, 19).i <= texel(8, 19).i);
  CHECK(at(10, 9.9) == background);
  camera.pitch_deg = -20;
  CHECK(at(10, 9.9) != background);
  camera.pitch_deg = 0;
  camera.roll_deg = 20;
  CHECK(at(18, 10) != background);
  CHECK(at(2, 10) == background);
}

}  // namespace moire::test
