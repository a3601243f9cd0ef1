#include "plugins/textured_plane/views.h"

#include <random>

namespace moire::test {

namespace {

struct Stand {
  double height, far, pitch_deg, fov_deg;
  ImageSize size;
};

// Sizes are odd and even in turn, so that pixels lie on both sides of the middle and astride it.
constexpr Stand stands[] = {
    {3, 60, -10, 60, {15, 18}},      // the usual
    {8, 90, 0, 70, {14, 13}},        // horizon in the middle of a row; many texels a pixel
    {8, 90, 0, 70, {14, 14}},        // horizon between two rows
    {2, 25, 15, 80, {13, 16}},       // looking up
    {0.05, 4, -5, 50, {15, 14}},     // many pixels a texel
    {0.3, 2.5, -35, 90, {12, 15}},   // no horizon; far limit in the picture
    {6, 1e6, -60, 50, {12, 12}},     // no far ground either
    {4, 7.5, -90, 100, {13, 14}},    // straight down, the far limit in the picture
    {4, 50, -89.97, 100, {14, 13}},  // nearly so
    {3, 2, 70, 120, {10, 10}},       // the far limit behind the picture
    {3, 60, 90, 60, {8, 8}},         // straight up
};

}  // namespace

Texels random_texels(int width, int height, Wrap wrap) {
  std::mt19937 engine(7);
  std::vector<Color> colors(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto channel = [&] { return static_cast<float>(engine() % 1000) / 999; };
  for (Color& c : colors) {
    c.r = channel();
    c.g = channel();
    c.b = channel();
  }
  return {colors, width, height, wrap};
}

std::vector<Camera> aligned_views() {
  std::vector<Camera> views;
  double yaw = 0;
  for (const Stand& s : stands) {
    for (int k = 0; k < 2; ++k) {
      views.push_back({.size = s.size,
                       .x = 3.2 - 9 * k,
                       .y = 1.7 + 4 * k,
                       .height = s.height,
                       .far = s.far,
                       .yaw_deg = yaw,
                       .pitch_deg = s.pitch_deg,
                       .roll_deg = 360.0 * k,
                       .fov_deg = s.fov_deg});
      yaw += k == 0 ? 90 : 180;
    }
  }
  return views;
}

std::vector<Camera> turned_views() {
  std::vector<Camera> views;
  constexpr double turns[][2] = {{34.4, 0}, {74.5, 12}, {0, -25}, {-200, 90}, {135, 180}, {90, 3}, {1e-7, 0}};
  std::size_t turn = 0;
  for (Camera view : aligned_views()) {
    view.yaw_deg = turns[turn][0];
    view.roll_deg = turns[turn][1];
    turn = (turn + 1) % std::size(turns);
    views.push_back(view);
  }
  return views;
}

}  // namespace moire::test
