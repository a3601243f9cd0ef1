// Where the camera is and what it looks at.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/shadow_planes/worlds.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

constexpr ImageSize size{200, 100};

bool are_near(const Vector& p, const Vector& q) { return length(p - q) <= 1e-14; }

}  // namespace

TEST_CASE("the target is seen in the middle, upright") {
  const Camera camera = camera_of(shadow_settings({{"view.x", 1.0},
                                                   {"view.y", -4.0},
                                                   {"view.z", 3.0},
                                                   {"view.target_x", 1.0},
                                                   {"view.target_y", 0.0},
                                                   {"view.target_z", 0.0}}),
                                  size);
  CHECK(are_near(camera.eye, {1, -4, 3}));
  CHECK(are_near(camera.ahead, {0, 0.8, -0.6}));
  CHECK(are_near(camera.right, {1, 0, 0}));
  CHECK(are_near(camera.down, {0, -0.6, -0.8}));
  const Pole middle = camera.image_of({1, 0, 0, 1});
  CHECK(std::abs(middle.x / middle.w - 100) <= 1e-12);
  CHECK(std::abs(middle.y / middle.w - 50) <= 1e-12);
}

TEST_CASE("who looks straight down has x to the right") {
  const Camera camera =
      camera_of(shadow_settings({{"view.x", 0.0}, {"view.y", 0.0}, {"view.z", 5.0}, {"view.target_z", 0.0}}), size);
  CHECK(are_near(camera.right, {1, 0, 0}));
  CHECK(are_near(camera.down, {0, -1, 0}));
}

TEST_CASE("angles look along x at yaw 0 and along y at 90, and roll turns clockwise") {
  const auto looking = [](double yaw, double pitch, double roll) {
    return camera_of(shadow_settings({{"view.aim", std::string("angles")},
                                      {"view.yaw_deg", yaw},
                                      {"view.pitch_deg", pitch},
                                      {"view.roll_deg", roll}}),
                     size);
  };
  CHECK(are_near(looking(0, 0, 0).ahead, {1, 0, 0}));
  CHECK(are_near(looking(0, 0, 0).right, {0, -1, 0}));
  CHECK(are_near(looking(90, 0, 0).ahead, {0, 1, 0}));
  CHECK(are_near(looking(90, 0, 0).down, {0, 0, -1}));
  CHECK(are_near(looking(90, 90, 0).ahead, {0, 0, 1}));
  CHECK(are_near(looking(90, -90, 0).ahead, {0, 0, -1}));
  // The camera's right side goes down.
  CHECK(are_near(looking(90, 0, 90).right, {0, 0, -1}));
  CHECK(are_near(looking(90, 0, 90).down, {-1, 0, 0}));
}

TEST_CASE("the angle of view spans the image's width, and rays go through the points that are seen") {
  const Camera camera = camera_of(shadow_settings({{"view.fov_deg", 90.0}, {"view.roll_deg", 20.0}}), size);
  CHECK(std::abs(camera.focal - 100) <= 1e-12);
  const Vector p = camera.eye + 7 * camera.ray({33, 71});
  const Pole seen = camera.image_of({p.x, p.y, p.z, 1});
  CHECK(std::abs(seen.x / seen.w - 33) <= 1e-11);
  CHECK(std::abs(seen.y / seen.w - 71) <= 1e-11);
}

}  // namespace moire::test
