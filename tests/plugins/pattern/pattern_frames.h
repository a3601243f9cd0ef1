// Frames of the scene `pattern`, and their exact pixels.
#pragma once

#include <memory>

#include "support/plugins.h"

namespace moire::test {

// With the scene that it is of: the frame may use it.
struct MadePattern {
  std::unique_ptr<Scene> scene;
  std::unique_ptr<Frame> frame;
};

inline MadePattern made_pattern(const Changes& changes, ImageSize size) {
  const ScenePlugin& plugin = scene_plugin("pattern");
  const Settings settings = changed(plugin.parameters, changes);
  MadePattern made{plugin.make(settings), nullptr};
  made.frame = made.scene->frame(settings, size);
  return made;
}

// The exact red of every pixel as a sum of double weights, rows from the top, and the fragments.
struct ExactPixels {
  PixelBlock block;
  double bound;

  ExactPixels(const Frame& frame, const Filter* filter = nullptr)
      : block({0, 0, frame.size().width, frame.size().height}, true),
        bound(frame.averages()->integrate(filter, block)) {}
  double red(int x, int y) const { return block.sum(block.slot(x, y)).r; }
  double weight(int x, int y) const { return block.weight(block.slot(x, y)); }
  std::vector<Fragment> fragments(int x, int y) const {
    std::vector<Fragment> all;
    block.for_each(block.slot(x, y), [&](const Fragment& f) { all.push_back(f); });
    return all;
  }
};

// What each kind is seen with: several settings of each, with everything off the grid.
struct Example {
  std::string name;
  Changes changes;
  Changes twice;  // what is other in an image of twice the size that shows the same
};

inline std::vector<Example> examples() {
  const auto kind = [](const char* name) { return std::pair<std::string, Value>("kind", std::string(name)); };
  std::vector<Example> all{
      {"zone plate",
       {kind("zone_plate"), {"view.x", 0.3}, {"view.y", -1.7}},
       {{"view.x", 0.6}, {"view.y", -3.4}, {"peak_frequency", 0.5}}},
      {"blob", {kind("blob"), {"sigma", 3.0}, {"view.x", 0.3}}, {{"sigma", 6.0}, {"view.x", 0.6}}},
      {"small blob", {kind("blob"), {"sigma", 0.2}, {"view.x", 0.3}}, {{"sigma", 0.4}, {"view.x", 0.6}}},
      {"wave",
       {kind("wave"),
        {"frequency", 0.31},
        {"angle_deg", 20.0},
        {"phase_deg", 33.0},
        {"amplitude", 0.3},
        {"second_amplitude", 0.1},
        {"second_frequency", 1.7}},
       {{"frequency", 0.155}, {"second_frequency", 0.85}}},
      {"disk",
       {kind("disk"), {"radius", 8.3}, {"view.x", 0.3}, {"view.y", 0.1}},
       {{"radius", 16.6}, {"view.x", 0.6}, {"view.y", 0.2}}},
      {"small disk", {kind("disk"), {"radius", 0.3}, {"view.x", 0.25}}, {{"radius", 0.6}, {"view.x", 0.5}}},
      {"star", {kind("star"), {"spokes", std::int64_t{7}}, {"angle_deg", 3.0}, {"view.x", 0.3}}, {{"view.x", 0.6}}},
      {"coarse star", {kind("star"), {"spokes", std::int64_t{2}}}, {}},
      {"fine star", {kind("star"), {"spokes", std::int64_t{90}}, {"view.x", 0.3}}, {{"view.x", 0.6}}},
  };
  for (const double angle : {0.0, 1e-8 * 180 / 3.141592653589793, 1e-3, 20.0, 45.0, 90.0, 161.3, 225.0}) {
    const std::string at = fmt::format(" at {}", angle);
    all.push_back({"edge" + at, {kind("edge"), {"angle_deg", angle}, {"offset", 2.3}}, {{"offset", 4.6}}});
    all.push_back({"grating" + at,
                   {kind("grating"), {"angle_deg", angle}, {"frequency", 0.13}, {"duty", 0.3}, {"phase_deg", 40.0}},
                   {{"frequency", 0.065}}});
    all.push_back(
        {"fine grating" + at, {kind("grating"), {"angle_deg", angle}, {"frequency", 1.7}}, {{"frequency", 0.85}}});
    all.push_back({"checkerboard" + at,
                   {kind("checkerboard"), {"angle_deg", angle}, {"cell", 3.3}, {"view.y", 0.1}},
                   {{"cell", 6.6}, {"view.y", 0.2}}});
    all.push_back(
        {"fine checkerboard" + at, {kind("checkerboard"), {"angle_deg", angle}, {"cell", 0.4}}, {{"cell", 0.8}}});
  }
  return all;
}

// Whether its colours are no mixtures of two by weight, but one each, and so rounded to floats: to 2^-25.
inline bool is_smooth(const Example& example) {
  const auto& kind = std::get<std::string>(example.changes.front().second);
  return kind == "zone_plate" || kind == "blob" || kind == "wave";
}

inline Changes with(Changes changes, const Changes& others) {
  for (const auto& other : others) changes.push_back(other);
  return changes;
}

}  // namespace moire::test
