#include "patterns.h"

#include <fmt/format.h>

#include "interleaved.h"
#include "run/workers.h"
#include "sampling/filters.h"
#include "terrain_views.h"

namespace moire::benchmark {

namespace {

constexpr ImageSize size{512, 512};
constexpr int rounds = 15;

struct Case {
  const char* kind;
  std::vector<std::pair<std::string, Value>> changes;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"zone_plate", {}},
      {"sinusoids", {}},
      {"wave", {}},
      {"grating", {{"angle_deg", 20.0}}},
      {"edge", {{"angle_deg", 20.0}}},
      {"edge", {{"tile", std::int64_t{1}}, {"angles", std::string("any")}}},
      {"disk", {{"radius", 200.0}}},
      {"disk", {{"radius", 1.5}, {"tile", std::int64_t{8}}}},
      {"blob", {{"sigma", 50.0}}},
      {"blob", {{"sigma", 1.5}, {"tile", std::int64_t{8}}}},
      {"star", {}},
      {"checkerboard", {}},
      {"checkerboard", {{"angle_deg", 20.0}}},
  };
  return all;
}

}  // namespace

void run_patterns(const Catalog& catalog) {
  fmt::print(
      "Patterns: median of {} rounds, time of one thread, 512 x 512 pixels, a frame made anew each time. Aim: exact "
      "averages in 5 ms.\n    {:<48} {:>8} {:>8} {:>8} {:>8} ms\n",
      rounds, "", "exact", "recorded", "point", "mitchell");
  const ScenePlugin& plugin = *catalog.find(Kind::scene, "pattern")->scene;
  const Workers one(1);
  const auto integral = contender(catalog, "integral", {}), point = contender(catalog, "point", {});
  const auto mitchell = make_filter("mitchell", {}, 1);
  for (const Case& c : cases()) {
    Settings settings(plugin.parameters);
    settings.set("kind", std::string(c.kind));
    std::string name = c.kind;
    for (const auto& [key, value] : c.changes) {
      settings.set(key, value);
      name += " " + key + " " + std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
    }
    const auto scene = plugin.make(settings);
    const auto work = [&](const Contender& contender, bool recording) {
      return Work{name, [&, recording] {
                    const auto frame = scene->frame(settings, size);
                    one.render(*contender.begin(*frame, 1), *frame, recording, [](std::size_t, const PixelBlock&) {});
                  }};
    };
    const auto t = interleaved({work(*integral, false), work(*integral, true), work(*point, false)}, rounds);
    std::string filtered = "-";
    if ((plugin.answers(settings) & Questions::filtered_averages) != Questions::none) {
      const Work slow{name, [&] {
                        const auto frame = scene->frame(settings, size);
                        one.for_each_block(*frame, false, Blocks::columns, [&](std::size_t, PixelBlock& block) {
                          frame->averages()->integrate(mitchell.get(), block);
                        });
                      }};
      filtered = fmt::format("{:.0f}", interleaved({slow}, 1)[0].median());
    }
    fmt::print("    {:<48} {:8.2f} {:8.2f} {:8.2f} {:>8}\n", name, t[0].median(), t[1].median(), t[2].median(),
               filtered);
  }
}

}  // namespace moire::benchmark
