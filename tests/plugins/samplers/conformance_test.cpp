// What every sampler must keep on every scene that it runs on, new plugins included: nothing but settings, seed, frame
// and pixel decides a result. Never threads, never the width of blocks, never whether fragments are recorded.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <sstream>
#include <tuple>

#include "sampling/filters.h"
#include "sampling/lookups.h"
#include "sampling/pattern_sampler.h"
#include "sanitized.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

constexpr ImageSize size = sanitized ? ImageSize{15, 11} : ImageSize{33, 27};  // no multiple of a block's width

// The table's defaults, and those with each other choice of each parameter that is one.
std::vector<Settings> variants(std::span<const Parameter> table) {
  std::vector<Settings> result{Settings(table)};
  // A small image needs no fine textures.
  if (result.front().values().contains("texels")) result.front().set("texels", std::int64_t{40});
  for (const Parameter& parameter : table) {
    if (parameter.type != Type::choice) continue;
    std::istringstream choices{std::string(parameter.choices)};
    for (std::string choice; choices >> choice;) {
      if (choice == parameter.text) continue;
      result.push_back(result.front());
      result.back().set(parameter.name, choice);
    }
  }
  return result;
}

bool has(Questions answered, Questions asked) { return (answered & asked) == asked; }

// A scene of its plugin's defaults, made once for all tests.
struct MadeScene {
  const Plugin* plugin;
  Settings settings;
  std::unique_ptr<Scene> scene;
};

const std::vector<MadeScene>& scenes() {
  // Never destroyed: at the program's end what scenes use is gone before them.
  static const std::vector<MadeScene>* const all = [] {
    auto* const result = new std::vector<MadeScene>;
    std::vector<MadeScene>& made = *result;
    for (const Plugin* plugin : catalog().all(Kind::scene)) {
      Settings settings(plugin->parameters());
      // Near ground shows all that far ground would.
      if (settings.values().contains("far")) settings.set("far", 400.0);
      made.push_back({plugin, settings, plugin->scene->make(settings)});
    }
    return result;
  }();
  return *all;
}

// Calls check(sampler, plugin, frame, lookup) for every sampler in each of its variants on each scene that it runs on,
// with every lookup that the scene allows.
template <class Check>
void for_each_pair(Check check) {
  std::vector<std::unique_ptr<Frame>> frames;  // all kept, so that each has an address of its own
  for (const MadeScene& made : scenes()) {
    const Questions answered = made.plugin->scene->answers(made.settings);
    const Frame& frame = *frames.emplace_back(made.scene->frame(made.settings, size));
    for (const Plugin* plugin : catalog().all(Kind::sampler)) {
      for (const Settings& settings : variants(plugin->parameters())) {
        const Questions asked = plugin->sampler->asks(settings);
        if (!has(answered, asked)) continue;
        const auto sampler = make_sampler(*plugin->sampler, settings);
        for (const NamedSummary& lookup : lookups()) {
          const auto made_lookup = make_lookup(lookup.name);
          // Who sees whole polygons looks nothing up.
          if (made_lookup && (!has(answered, Questions::surface) || has(asked, Questions::polygons))) continue;
          // Those that filter footprints have many fragments each, and are the same to all settings of a sampler.
          if (!lookup.parameters.empty() && settings != variants(plugin->parameters()).front()) continue;
          // OpenImageIO is not compiled with sanitizers; its own tests ask it from many threads under them.
          if (sanitized && lookup.name == "oiio") continue;
          CAPTURE(made.plugin->name, plugin->name, lookup.name, settings.values());
          check(*sampler, *plugin, frame, made_lookup.get());
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("every sampler gives the same bits on one thread and on two, in blocks of any width, recording or not") {
  for_each_pair([](const Sampler& sampler, const Plugin&, const Frame& frame, const Lookup* lookup) {
    const Rendered image = rendered(sampler, frame, lookup);
    CHECK(first_difference(image, rendered(sampler, frame, lookup)) == "");
    for (const int threads : {1, 2}) {
      for (const int block_width : {1, 7, 32, size.width}) {
        if (sanitized && (threads == 1 || block_width != 7)) continue;
        for (const bool recording : {true, false}) {
          CAPTURE(threads, block_width, recording);
          const Manner manner{threads, block_width, recording};
          CHECK(first_difference(image, rendered(sampler, frame, lookup, manner)) == "");
        }
      }
    }
  });
}

TEST_CASE("what is counted does not depend on threads or on recording") {
  for_each_pair([](const Sampler& sampler, const Plugin&, const Frame& frame, const Lookup* lookup) {
    const Counters counters = rendered(sampler, frame, lookup).counters;
    CHECK(counters.queries > 0);
    CHECK(counters == rendered(sampler, frame, lookup, {.threads = 2}).counters);
    CHECK(counters == rendered(sampler, frame, lookup, {.recording = false}).counters);
  });
}

TEST_CASE("every sampler fills every pixel with weights and colours that are finite and not negative") {
  for_each_pair([](const Sampler& sampler, const Plugin&, const Frame& frame, const Lookup* lookup) {
    const Rendered image = rendered(sampler, frame, lookup);
    const auto is_sound = [](const Content& pixel) {
      return std::abs(pixel.weight - 1) <= 1e-9 && !pixel.fragments.empty() &&
             std::all_of(pixel.fragments.begin(), pixel.fragments.end(), [](const Fragment& f) {
               return f.weight > 0 && f.weight <= 1 + 1e-9 && std::isfinite(f.color.r) && std::isfinite(f.color.g) &&
                      std::isfinite(f.color.b);
             });
    };
    CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), is_sound));
  });
}

TEST_CASE("samplers that claim to draw no random numbers give the same bits for every seed") {
  for_each_pair([](const Sampler& sampler, const Plugin& plugin, const Frame& frame, const Lookup* lookup) {
    if (!plugin.sampler->claims.deterministic) return;
    CHECK(first_difference(rendered(sampler, frame, lookup), rendered(sampler, frame, lookup, {}, 12345)) == "");
  });
}

// Filters with a margin beyond their usual one, or other shapes, are settings; what blocks do is the same.
TEST_CASE("every pattern under every filter has finite pixels of weight 1, the same bits in all blocks and threads") {
  const auto check = [](const Plugin& plugin, const FilterChoice& filter, const Frame& frame) {
    CAPTURE(plugin.name, filter.name);
    const auto sampler = make_sampler(*plugin.sampler, Settings(plugin.parameters()), filter);
    const Rendered image = rendered(*sampler, frame, nullptr, {.block_width = frame.size().width});
    CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), [](const Content& pixel) {
      return std::abs(pixel.weight - 1) <= 1e-12 && !pixel.fragments.empty() && std::isfinite(pixel.color.r) &&
             std::isfinite(pixel.color.g) && std::isfinite(pixel.color.b);
    }));
    for (const auto& [threads, block_width, recording] :
         {std::tuple{1, 1, true}, std::tuple{2, 7, true}, std::tuple{2, 5, false}, std::tuple{1, 32, false}}) {
      if (sanitized && block_width != 5) continue;
      CAPTURE(threads, block_width, recording);
      CHECK(first_difference(image, rendered(*sampler, frame, nullptr, {threads, block_width, recording})) == "");
    }
  };
  for (const MadeScene& made : scenes()) {
    if (made.plugin->name != "cartoon" && made.plugin->name != "heightfield") continue;
    const auto frame = made.scene->frame(made.settings, {17, 11});
    for (const NamedSummary& filter : filters()) {
      for (const Plugin* plugin : catalog().all(Kind::sampler)) {
        const bool is_cheap = made.plugin->name == "cartoon" || plugin->name == "jittered";
        if (plugin->sampler->make_points && is_cheap) check(*plugin, {std::string(filter.name), {}}, *frame);
      }
    }
  }
}

TEST_CASE("every scene runs under at least one sampler, and every sampler on at least one scene") {
  std::vector<const Plugin*> samplers;
  std::vector<const Frame*> frames;
  for_each_pair([&](const Sampler&, const Plugin& plugin, const Frame& frame, const Lookup*) {
    samplers.push_back(&plugin);
    frames.push_back(&frame);
  });
  for (const Plugin* plugin : catalog().all(Kind::sampler)) {
    CAPTURE(plugin->name);
    CHECK(std::count(samplers.begin(), samplers.end(), plugin) > 0);
  }
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  CHECK(frames.size() == scenes().size());
}

}  // namespace moire::test
