// The exact picture of a real terrain, held to 64 x 64 rays a pixel, each on its own way.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>

#include "support/plugins.h"

namespace moire::test {

// n x n regular samples are off where edges cross their squares: of 2 n or so squares an edge, each off by about as
// much as the others but in its own way, so that their mean is off by n^(-3/2) of the contrast. If it were the exact
// picture that is wrong, four times as many rays would not bring them eight times as near.
TEST_CASE("on Puget Sound 64 x 64 rays a pixel come as near to the exact picture as they are to each other") {
  const char* const folder = std::getenv("MOIRE_DATA");
  if (!folder) SKIP("MOIRE_DATA is not set; point it at the data folder to test on Puget Sound");
  const std::string data = std::string(folder) + "/terrain/puget_sound/";
  constexpr ImageSize size{400, 400};
  constexpr int columns = 9, rows = 49;
  constexpr double goal = 1.5;  // times what the law above says

  const ScenePlugin& plugin = scene_plugin("heightfield");
  Settings settings = changed(plugin.parameters, {{"height", data + "height.png"},
                                                  {"color", data + "color.png"},
                                                  {"grid", std::string("color")},
                                                  {"height_scale", 30.0 / 43798},
                                                  {"height_offset", 150.0},
                                                  {"far", 30000.0},
                                                  {"coherence", std::string("none")},
                                                  {"view.x", 512.3},
                                                  {"view.y", 511.6},
                                                  {"view.yaw_deg", 20.0},
                                                  {"view.fov_deg", 10.0}});
  const auto scene = plugin.make(settings);
  struct Case {
    double pitch, height, levels;
  };
  for (const Case& c : {Case{40, 2800, 0.02}, Case{20, 1300, 0.04}, Case{5, 1000, 0.15}}) {
    CAPTURE(c.pitch);
    settings.set("view.pitch_deg", -c.pitch);
    settings.set("view.height", c.height);
    const auto frame = scene->frame(settings, size);
    const auto area = sampler("area", {{"method", std::string("exact")}});
    const auto rendering = area->begin({.frame = *frame});

    Counters counters;
    double rmse[2];
    for (const int n : {16, 64}) {
      std::vector<SamplePoint> points(static_cast<std::size_t>(n * n));
      std::vector<Hit> hits(points.size());
      double squares = 0;
      for (int column = 0; column < columns; ++column) {
        const int x = 7 + column * 48;
        PixelBlock block({x, 0, 1, size.height}, false);
        rendering->render(block);
        for (int row = 0; row < rows; ++row) {
          const int y = 5 + row * 8;
          for (int k = 0; k < n * n; ++k) {
            points[static_cast<std::size_t>(k)] = {x + (k / n + 0.5) / n, y + 1 - (k % n + 0.5) / n};
          }
          frame->trace(points, hits, counters);
          double r = 0, g = 0, b = 0;
          for (const Hit& hit : hits) r += hit.color.r, g += hit.color.g, b += hit.color.b;
          const Color exact = block.color(block.slot(x, y));
          for (const double off : {exact.r - r / (n * n), exact.g - g / (n * n), exact.b - b / (n * n)}) {
            squares += 255 * 255 * off * off;
          }
        }
      }
      rmse[n / 64] = std::sqrt(squares / (3 * columns * rows));
    }
    CAPTURE(rmse[0], rmse[1]);
    CHECK(rmse[1] <= goal * rmse[0] / 8);
    CHECK(rmse[1] <= c.levels);
  }
}

}  // namespace moire::test
