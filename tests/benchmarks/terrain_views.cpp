#include "terrain_views.h"

#include <cstdlib>
#include <numeric>

#include "terrain.h"
#include "view_settings.h"

namespace moire::benchmark {

namespace {

constexpr heightfield::Model model{.grid = false};

heightfield::Look look_of(const Settings& settings, const heightfield::Voxels& voxels, ImageSize size) {
  const heightfield::Camera camera = heightfield::camera_of(settings, size);
  return {size, heightfield::view_of(settings, voxels, camera), camera, heightfield::manner_of(settings)};
}

}  // namespace

Settings terrain_settings(const Catalog& catalog, const TerrainView& view) {
  const Plugin* plugin = catalog.find(Kind::scene, "heightfield");
  Settings settings(plugin->parameters());
  const std::string data = std::string(std::getenv("MOIRE_DATA")) + "/terrain/puget_sound/";
  settings.set("height", data + "height.png");
  settings.set("color", data + "color.png");
  settings.set("grid", std::string("color"));
  settings.set("height_scale", 30.0 / 43798);
  settings.set("height_offset", 150.0);
  settings.set("far", 30000.0);
  settings.set("walk", std::string("major"));
  settings.set("levels", std::string("floor"));
  settings.set("view.x", 512.3);
  settings.set("view.y", 511.6);
  settings.set("view.height", view.height);
  settings.set("view.yaw_deg", 20.0);
  settings.set("view.pitch_deg", -view.pitch_deg);
  settings.set("view.fov_deg", 10.0);
  return settings;
}

std::unique_ptr<Contender> contender(const Catalog& catalog, const std::string& type,
                                     const std::vector<std::pair<std::string, Value>>& settings,
                                     const std::string& lookup, const std::string& filter) {
  const Plugin* plugin = catalog.find(Kind::sampler, type);
  SamplerChoice choice{type, plugin, Settings(plugin->parameters()), lookup, filter};
  for (const auto& [name, value] : settings) choice.settings.set(name, value);
  return std::make_unique<Contender>(choice);
}

OnePiece::OnePiece(const Settings& settings, ImageSize size)
    : voxels_(heightfield::load_terrain(settings)),
      look_(look_of(settings, voxels_, size)),
      sky_(parse_color(settings.text("sky"))) {}

void OnePiece::point(PixelBlock& block) const {
  std::vector<SamplePoint> points(static_cast<std::size_t>(block.height));
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = {x + 0.5, block.height - 0.5 - static_cast<double>(k)};
    const std::size_t bottom = block.slot(x, block.height - 1);
    block.fill([&](auto add) {
      look_.rays<model>(
          points, block.counters,
          [&](std::size_t k, const auto& walk, const heightfield::Voxel& voxel, const auto&, double) {
            add(bottom - k, walk.element(voxel), 1.0, heightfield::color_of(*voxel.cell));
          },
          [&](std::size_t k) { add(bottom - k, background, 1.0, sky_); });
    });
  }
}

void OnePiece::area(PixelBlock& block) const {
  std::vector<double> cuts(static_cast<std::size_t>(block.height) + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    const std::size_t bottom = block.slot(x, block.height - 1);
    block.fill([&](auto add) {
      look_.stretches<model>(
          {{x + 0.5, static_cast<double>(block.height)}, {x + 0.5, 0}, cuts}, 0, block.counters,
          [&](std::size_t slot, heightfield::Run run, const auto& walk, const heightfield::Voxel* voxel, const auto&,
              Tally::Sum& sum) {
            const Color color = voxel ? heightfield::color_of(*voxel->cell) : sky_;
            sum.add(run.length, color);
            add.record(bottom - slot, voxel ? walk.element(*voxel) : background, run.length, color);
          },
          [&](std::size_t slot, const Tally::Sum& sum) { add.sum(bottom - slot, sum); });
    });
  }
}

void OneByOne::render(PixelBlock& block) const {
  std::vector<double> cuts(static_cast<std::size_t>(block.height) + 1);
  std::iota(cuts.begin(), cuts.end(), 0.0);
  Tally pieces(0, block.recording());
  const double bottom = block.height;
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    const ImageLine line{{x + 0.5, bottom}, {x + 0.5, 0}, cuts};
    pieces.reset(line.stretches());
    frame_.lines()->along({&line, 1}, lookup_, pieces);
    const std::size_t lowest = block.slot(x, block.height - 1);
    for (std::size_t i = 0; i < pieces.slots(); ++i) block.mix(lowest - i, pieces, i, 1);
    block.counters += pieces.counters;
  }
}

}  // namespace moire::benchmark
