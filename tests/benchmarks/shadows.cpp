#include "shadows.h"

#include <fmt/format.h>

#include <moire/plugin.h>

#include "interleaved.h"

namespace moire::benchmark {

namespace {

constexpr int side = 512;
constexpr int rounds = 7;

}  // namespace

std::vector<LightPoint> lattice(std::size_t count) {
  std::vector<LightPoint> points;
  const auto part = [](double x) { return static_cast<float>(x - std::floor(x)); };
  for (std::size_t k = 0; k < count; ++k) {
    const auto index = static_cast<double>(k);
    points.push_back({part(0.5 + index * 0.7548776662466927), part(0.5 + index * 0.5698402909980532)});
  }
  return points;
}

void run_shadows(const Catalog& catalog) {
  const std::vector<LightPoint> lights = lattice(256);
  fmt::print(
      "Hard shadows of {} light points on a map of {} x {} cells: ns a cell and light point, median of {} rounds, one "
      "thread. Aim: 0.5 with up to three occluders. Rays: trace(), one a cell.\n"
      "    {:<10} {:>8} {:>8} {:>8}   {}\n",
      lights.size(), side, side, rounds, "", "by area", "middle", "rays", "by area over rays");
  const ScenePlugin& plugin = *catalog.find(Kind::scene, "shadow_planes")->scene;
  for (const char* kind : {"tilted", "parallel", "three", "wall", "slats"}) {
    Settings settings(plugin.parameters);
    settings.set("kind", std::string(kind));
    // The floor, from above, fills the image.
    settings.set("view.x", 0.0);
    settings.set("view.y", 0.0);
    settings.set("view.z", 100.0);
    settings.set("view.target_z", 0.0);
    settings.set("view.fov_deg", 3.43);
    const auto scene = plugin.make(settings);
    const auto frame = scene->frame(settings, {side, side});
    const auto map = [&](ShadowEdges edges) {
      return Work{kind, [&, edges] {
                    IrradianceMap irradiance{side, side, std::vector<float>(static_cast<std::size_t>(side) * side)};
                    frame->receivers()->add_hard_shadows(0, lights, edges, irradiance);
                  }};
    };
    std::vector<SamplePoint> points;
    for (int x = 0; x < side; ++x) {
      for (int y = side; y-- > 0;) {
        const LightPoint& light = lights[static_cast<std::size_t>(37 * x + 101 * y) % lights.size()];
        points.push_back({x + 0.5, y + 0.5, light.u, light.v});
      }
    }
    std::vector<Hit> hits(points.size());
    const Work rays{"rays", [&] {
                      Counters counters;
                      for (std::size_t x = 0; x < side; ++x)
                        frame->trace(std::span(points).subspan(x * side, side), std::span(hits).subspan(x * side, side),
                                     counters);
                    }};
    const auto t = interleaved({map(ShadowEdges::by_area), map(ShadowEdges::by_middle), rays}, rounds);
    const double cells = static_cast<double>(side) * side, all = cells * static_cast<double>(lights.size());
    fmt::print("    {:<10} {:8.3f} {:8.3f} {:8.1f}   {:.4f}\n", kind, 1e6 * t[0].median() / all,
               1e6 * t[1].median() / all, 1e6 * t[2].median() / cells,
               ratio(t[0], t[2]).median / static_cast<double>(lights.size()));
  }
}

}  // namespace moire::benchmark
