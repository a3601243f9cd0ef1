#include "sampling/lookups.h"

#include <array>

#include "sampling/options.h"

#include "sampling/options.h"

namespace moire {

namespace {

struct Entry {
  NamedSummary description;
  std::unique_ptr<Lookup> (*make)(const Settings& settings);
};

constexpr std::array entries{
    Entry{{"nearest", "the texel that is hit, as the scene colours it"},
          [](const Settings&) { return std::unique_ptr<Lookup>(); }},
    Entry{{"linear_across", "two texels, interpolated across the direction of view (Cohen-Or 1997, eq. 4)"},
          [](const Settings&) { return make_linear_across(); }},
    Entry{{"bilinear", "the four nearest texels, interpolated along both texture axes"},
          [](const Settings&) { return make_bilinear(); }},
};

}  // namespace

std::span<const NamedSummary> lookups() {
  static constexpr auto descriptions = [] {
    std::array<NamedSummary, entries.size()> result{};
    for (std::size_t k = 0; k < entries.size(); ++k) result[k] = entries[k].description;
    return result;
  }();
  return descriptions;
}

std::unique_ptr<Lookup> make_lookup(std::string_view name, const Settings& settings) {
  for (const Entry& entry : entries) {
    if (entry.description.name == name) return entry.make(with_defaults(entry.description.parameters, settings));
  }
  return nullptr;
}

}  // namespace moire
