#include "support/plugins.h"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

#include "sampling/pattern_sampler.h"

namespace moire::test {

namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool same_bits(Color a, Color b) { return same_bits(a.r, b.r) && same_bits(a.g, b.g) && same_bits(a.b, b.b); }
bool same_bits(const Fragment& a, const Fragment& b) {
  return a.element == b.element && same_bits(a.weight, b.weight) && same_bits(a.color, b.color);
}

std::string difference(const Content& one, const Content& other, bool recorded) {
  if (!same_bits(one.weight, other.weight)) return fmt::format("weight {:.17g}, {:.17g}", one.weight, other.weight);
  if (!same_bits(one.color, other.color)) return fmt::format("red {:.9g}, {:.9g}", one.color.r, other.color.r);
  if (!recorded) return {};
  if (one.fragments.size() != other.fragments.size()) {
    return fmt::format("{} fragments, {}", one.fragments.size(), other.fragments.size());
  }
  for (std::size_t k = 0; k < one.fragments.size(); ++k) {
    const Fragment &a = one.fragments[k], &b = other.fragments[k];
    if (same_bits(a, b)) continue;
    return fmt::format("fragment {}: element {:x} of weight {:.17g}, {:x} of {:.17g}", k, a.element, a.weight,
                       b.element, b.weight);
  }
  return {};
}

}  // namespace

const Catalog& catalog() {
  static const Catalog all = Catalog::open(plugin_folders({}));
  return all;
}

const ScenePlugin& scene_plugin(std::string_view name) { return *catalog().find(Kind::scene, name)->scene; }

const SamplerPlugin& sampler_plugin(std::string_view name) { return *catalog().find(Kind::sampler, name)->sampler; }

Settings changed(std::span<const Parameter> table, const Changes& changes) {
  Settings settings(table);
  for (const auto& [name, value] : changes) settings.set(name, value);
  return settings;
}

std::unique_ptr<Sampler> sampler(std::string_view name, const Changes& changes) {
  const SamplerPlugin& plugin = sampler_plugin(name);
  return make_sampler(plugin, changed(plugin.parameters, changes));
}

Rendered rendered(const Sampler& sampler, const Frame& frame, const Lookup* lookup, Manner manner, std::uint64_t seed) {
  return rendered(*sampler.begin({.frame = frame, .lookup = lookup, .seed = seed}), frame, manner);
}

Rendered rendered(const Rendering& rendering, const Frame& frame, Manner manner) {
  const ImageSize size = frame.size();
  Rendered image{
      size, std::vector<Content>(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)), {}};
  const Workers workers(manner.threads, manner.block_width);
  const Blocks order = manner.order.value_or(Workers::order(rendering, manner.recording));
  std::vector<Counters> counters(workers.blocks(size, order));
  workers.for_each_block(frame, manner.recording, order, [&](std::size_t index, PixelBlock& block) {
    rendering.render(block);
    block.settle();
    counters[index] = block.counters;
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      for (int y = block.y0; y < block.y0 + block.height; ++y) {
        const std::size_t slot = block.slot(x, y);
        Content& pixel = image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                      static_cast<std::size_t>(x)];
        pixel.weight = block.weight(slot);
        pixel.color = block.color(slot);
        block.for_each(slot, [&](const Fragment& fragment) { pixel.fragments.push_back(fragment); });
      }
    }
  });
  for (const Counters& block : counters) image.counters += block;
  return image;
}

std::string first_difference(const Rendered& one, const Rendered& other) {
  if (one.size != other.size) return "the sizes differ";
  const auto has_fragments = [](const Rendered& image) {
    return !image.pixels.empty() && !image.pixels.front().fragments.empty();
  };
  const bool recorded = has_fragments(one) && has_fragments(other);
  for (std::size_t k = 0; k < one.pixels.size(); ++k) {
    const std::string text = difference(one.pixels[k], other.pixels[k], recorded);
    const auto width = static_cast<std::size_t>(one.size.width);
    if (!text.empty()) return fmt::format("pixel ({}, {}): {}", k % width, k / width, text);
  }
  return {};
}

}  // namespace moire::test
