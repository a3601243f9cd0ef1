// The program's own plugins as tests use them, and images that keep all their fragments.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <moire/plugin.h>

#include "loading/catalog.h"
#include "run/workers.h"

namespace moire::test {

// Settings that differ from a table's defaults.
using Changes = std::vector<std::pair<std::string, Value>>;

// The plugins beside the test program.
const Catalog& catalog();
const ScenePlugin& scene_plugin(std::string_view name);
const SamplerPlugin& sampler_plugin(std::string_view name);

Settings changed(std::span<const Parameter> table, const Changes& changes);
std::unique_ptr<Sampler> sampler(std::string_view name, const Changes& changes = {});

// All that a rendering leaves in a pixel.
struct Content {
  double weight = 0;  // before division
  Color color;
  std::vector<Fragment> fragments;  // in the order of deposit; none unless recorded
};

struct Rendered {
  ImageSize size;
  std::vector<Content> pixels;  // row 0 the top
  Counters counters;

  const Content& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)];
  }
};

struct Manner {
  int threads = 1;
  int block_width = Workers::default_block_width;
  bool recording = true;
  std::optional<Blocks> order = {};  // none: what the host would choose
};

Rendered rendered(const Sampler& sampler, const Frame& frame, const Lookup* lookup = nullptr, Manner manner = {},
                  std::uint64_t seed = 0);
// One that has begun.
Rendered rendered(const Rendering& rendering, const Frame& frame, Manner manner = {});

// A sentence about the first pixel whose weight, colour or fragments have other bits; empty if there is none. Fragments
// are compared where both images have recorded them.
std::string first_difference(const Rendered& one, const Rendered& other);

}  // namespace moire::test
