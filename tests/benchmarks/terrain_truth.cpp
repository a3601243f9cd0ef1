#include "terrain_truth.h"

#include <fmt/format.h>

#include "exact/visible_voxels.h"
#include "interleaved.h"
#include "terrain.h"
#include "terrain_views.h"
#include "view_settings.h"

namespace moire::benchmark {

namespace {

constexpr ImageSize size{400, 400};

// Takes polygons and does nothing with them.
class Counter final : public PolygonSink {
 public:
  void polygon(const Polygon& p) override {
    ++polygons;
    corners += p.points.size();
    voxels += p.element != last_;
    last_ = p.element;
  }
  std::uint64_t polygons = 0, corners = 0, voxels = 0;

 private:
  Element last_ = background;
};

}  // namespace

void terrain_truth(const Catalog& catalog) {
  constexpr double goals_ms[] = {300, 500, 12000};
  int k = 0;
  for (const TerrainView& view : views) {
    Settings settings = terrain_settings(catalog, view);
    settings.set("walk", std::string("grid"));
    settings.set("levels", std::string("none"));
    const auto scene = catalog.find(Kind::scene, "heightfield")->scene->make(settings);
    const auto frame = scene->frame(settings, size);
    const auto area = contender(catalog, "area", {{"method", std::string("exact")}});
    const Workers one(1), two(2), whole(1, size.width);

    const heightfield::Voxels voxels(heightfield::load_terrain(settings));
    const heightfield::Camera camera = heightfield::camera_of(settings, size);
    const heightfield::Look look(size, heightfield::view_of(settings, voxels, camera), camera, {});
    const heightfield::VisibleVoxels visible(look, {});
    Counter counter;
    std::uint64_t visited = 0;

    const auto render = [&](const Workers& workers) {
      workers.render(*area->begin(*frame, 1), *frame, false, [](std::size_t, const PixelBlock&) {});
    };
    const int rounds = view.pitch_deg > 10 ? 5 : 1;
    const std::vector<Work> works{{"frame", [&] { render(one); }},
                                  {"polygons", [&] {
                                     counter = {};
                                     visited = visible.visit({0, 0, 400, 400}, counter);
                                   }}};
    const auto t = interleaved(works, rounds);
    const auto seen = static_cast<double>(counter.voxels);
    fmt::print(
        "  pitch {}: exact area {:.0f} ms a frame (goal <= {}), {:.0f} ns a visible voxel, of which polygons {:.0f}; "
        "{} voxels looked at, {} visible, {:.2f} polygons each, {:.1f} corners\n",
        view.pitch_deg, t[0].median(), goals_ms[k++], 1e6 * t[0].median() / seen, 1e6 * t[1].median() / seen, visited,
        counter.voxels, static_cast<double>(counter.polygons) / seen, static_cast<double>(counter.corners) / seen);
    const auto blocks = interleaved({{"32", [&] { render(one); }}, {"all", [&] { render(whole); }}}, rounds);
    const Ratio waste = ratio(blocks[0], blocks[1]);
    fmt::print("    {:<52} {:5.2f}  ({:.2f} .. {:.2f})\n", "exact area: blocks of 32 columns over the whole image",
               waste.median, waste.low, waste.high);
    const auto both = interleaved({{"one", [&] { render(one); }}, {"two", [&] { render(two); }}}, rounds, Clock::wall);
    const Ratio r = ratio(both[0], both[1]);
    fmt::print("    {:<52} {:5.2f}  ({:.2f} .. {:.2f})   {}\n", "exact area: one thread over two", r.median, r.low,
               r.high, ">= 1.7 where two cores are free");
  }
}

}  // namespace moire::benchmark
