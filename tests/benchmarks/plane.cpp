#include "plane.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "interleaved.h"

namespace moire::benchmark {

namespace {

constexpr ImageSize size{512, 512};
constexpr int horizon = 256, rows = 255;  // full rows of ground below the one that the far limit cuts off

// A height of 100 units, a focal length of 500 pixels, looking level.
Settings settings_of(const Plugin& plugin, const std::string& texture) {
  Settings settings(plugin.parameters());
  if (!texture.empty()) settings.set("texture", std::string(std::getenv("MOIRE_DATA")) + "/texture/" + texture);
  settings.set("view.x", 300.3);
  settings.set("view.y", 100.7);
  settings.set("view.height", 100.0);
  settings.set("view.pitch_deg", 0.0);
  settings.set("view.fov_deg", 2 * std::atan(size.width / 2.0 / 500) * 180 / std::numbers::pi);
  settings.set("far", 50000.0);
  return settings;
}

// Averages a part of the picture in blocks as the host makes them of rows; returns the largest bound.
double average(const Frame& frame, const PixelArea& area) {
  constexpr int thickness = 16;
  PixelBlock block(area, false, Blocks::rows);
  double bound = 0;
  for (int y = 0; y < area.height; y += thickness) {
    block.move_to({area.x0, area.y0 + y, area.width, std::min(thickness, area.height - y)});
    bound = std::max(bound, frame.averages()->integrate(nullptr, block));
  }
  return bound;
}

}  // namespace

void textured_plane(const Catalog& catalog) {
  const Plugin& plugin = *catalog.find(Kind::scene, "textured_plane");
  fmt::print("Textured plane: {} x {} pixels of ground, one thread.\n", size.width, rows);
  struct Case {
    const char* name;
    const char* texture;
    double goal_ms;
  };
  for (const Case& c : {Case{"photograph of 1024 x 1024", "naip_airfield_1024.png", 700},
                        Case{"checkerboard, cells of 16 units", "", 50}}) {
    Settings settings = settings_of(plugin, c.texture);
    const auto scene = plugin.scene->make(settings);
    const auto along_columns = scene->frame(settings, size);
    settings.set("view.yaw_deg", 0.0);
    const auto along_rows = scene->frame(settings, size);
    const PixelArea ground{0, horizon + 1, size.width, rows};
    const auto t = interleaved(
        {{"yaw -90", [&] { average(*along_columns, ground); }}, {"yaw 0", [&] { average(*along_rows, ground); }}}, 5);
    fmt::print("  {}, strips: {:.0f} ms a frame at yaw -90, {:.0f} at yaw 0; goal {:.0f}: {:.2f} and {:.2f} of it\n",
               c.name, t[0].median(), t[1].median(), c.goal_ms, t[0].median() / c.goal_ms, t[1].median() / c.goal_ms);

    settings.set("view.yaw_deg", 34.4);
    const auto turned = scene->frame(settings, size);
    for (const int k : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      constexpr int pixels = 8, apart = size.width / pixels;
      double bound = 0;
      const auto row = interleaved({{"row",
                                     [&] {
                                       for (int x = 0; x < pixels; ++x) {
                                         bound = std::max(bound, average(*turned, {x * apart + 5, horizon + k, 1, 1}));
                                       }
                                     }}},
                                   k < 8 ? 1 : 5);
      fmt::print("    quadtree, row {:>3} below the horizon: {:8.1f} us a pixel, error <= {:.1e}\n", k,
                 1e3 * row[0].median() / pixels, bound);
    }
  }
}

}  // namespace moire::benchmark
