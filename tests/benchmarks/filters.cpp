#include "filters.h"

#include <fmt/format.h>

#include "interleaved.h"
#include "sampling/filters.h"
#include "terrain_views.h"

namespace moire::benchmark {

void run_filters(const Catalog& catalog) {
  constexpr ImageSize size{256, 256};
  constexpr int rounds = 15;
  const Plugin* plugin = catalog.find(Kind::scene, "cartoon");
  const Settings settings(plugin->parameters());
  const auto scene = plugin->scene->make(settings);
  const auto frame = scene->frame(settings, size);
  const Workers one(1);
  fmt::print("Filters: 4 x 4 points on the cartoon, {} x {} pixels, ms of one thread; medians of {} rounds.\n",
             size.width, size.height, rounds);
  const auto compare = [&](const char* sampler, const std::vector<std::pair<std::string, Value>>& grid) {
    std::vector<std::unique_ptr<Contender>> contenders;
    std::vector<Work> works;
    for (const NamedSummary& filter : filters()) {
      contenders.push_back(contender(catalog, sampler, grid, "nearest", std::string(filter.name)));
      const Contender* made = contenders.back().get();
      works.push_back({std::string(filter.name), [&, made] {
                         one.render(*made->begin(*frame, 1), *frame, false, [](std::size_t, const PixelBlock&) {});
                       }});
    }
    const auto t = interleaved(works, rounds);
    for (std::size_t k = 0; k < works.size(); ++k) {
      const Ratio over_box = ratio(t[k], t[0]);
      fmt::print("  {:<12}{:<12}{:7.2f} ms  {:5.2f} of the box ({:.2f} .. {:.2f})\n", sampler, works[k].name,
                 t[k].median(), over_box.median, over_box.low, over_box.high);
    }
  };
  compare("supersample", {{"n", std::int64_t{4}}, {"layout", std::string("grid")}});
  compare("jittered", {{"n", std::int64_t{4}}});
}

}  // namespace moire::benchmark
