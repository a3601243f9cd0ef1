#include "sampling/filters.h"

#include <algorithm>
#include <array>

#include "sampling/options.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter tent_parameters[] = {
    real("tent.radius", 1, 1e-3, 16, "pixels", "from the pixel's middle to where the weight is 0"),
};
constexpr Parameter gaussian_parameters[] = {
    real("gaussian.sigma", 0.5, 1e-3, 4, "pixels", "standard deviation; cut off at 4 of them"),
};
constexpr Parameter mitchell_parameters[] = {
    real("mitchell.b", 1.0 / 3, 0, 1, "", "B of Mitchell and Netravali: more is blurrier"),
    real("mitchell.c", 1.0 / 3, 0, 1, "", "C of Mitchell and Netravali: more is sharper and rings more"),
};
constexpr Parameter lanczos_parameters[] = {
    integer("lanczos.lobes", 3, 1, 8, "pixels", "radius: lobes of the sinc on either side"),
};

using Maker = std::unique_ptr<Filter> (*)(const Settings& settings, double spacing);

template <int taps>
std::unique_ptr<Filter> bartlett(const Settings&, double spacing) {
  return make_bartlett(taps, spacing);
}

struct Entry {
  NamedSummary description;
  Maker make;
  bool is_centred_on_points = false;
};

constexpr std::array entries{
    Entry{{"box", "all points of a pixel alike, and no others"},
          [](const Settings&, double) { return std::unique_ptr<Filter>(); }},
    Entry{{"bartlett_3", "1 2 1 each way over the points of the pattern; belongs to 2 x 2 points (Maddock, Table 4.1)"},
          bartlett<3>,
          true},
    Entry{{"bartlett_5", "1 2 3 2 1 each way over the points of the pattern; belongs to 3 x 3 points"},
          bartlett<5>,
          true},
    Entry{{"bartlett_7", "1 2 3 4 3 2 1 each way over the points of the pattern; belongs to 4 x 4 points"},
          bartlett<7>,
          true},
    Entry{{"tent", "falls straight from the pixel's middle", tent_parameters},
          [](const Settings& s, double) { return make_tent(s.real("tent.radius")); }},
    Entry{{"gaussian", "exp(-x^2 / (2 sigma^2)), of integral 1 (Maddock's lacks the 2)", gaussian_parameters},
          [](const Settings& s, double) { return make_gaussian(s.real("gaussian.sigma")); }},
    Entry{{"mitchell", "a cubic of radius 2 with small negative lobes (Mitchell, Netravali 1988)", mitchell_parameters},
          [](const Settings& s, double) { return make_mitchell(s.real("mitchell.b"), s.real("mitchell.c")); }},
    Entry{{"lanczos", "a sinc in the window of a wider one, with negative lobes (Duchon 1979)", lanczos_parameters},
          [](const Settings& s, double) { return make_lanczos(static_cast<int>(s.integer("lanczos.lobes"))); }},
};

const Entry& entry(std::string_view name) {
  return *std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.description.name == name; });
}

}  // namespace

std::span<const NamedSummary> filters() {
  static constexpr auto descriptions = [] {
    std::array<NamedSummary, entries.size()> result{};
    for (std::size_t k = 0; k < entries.size(); ++k) result[k] = entries[k].description;
    return result;
  }();
  return descriptions;
}

std::unique_ptr<Filter> make_filter(std::string_view name, const Settings& settings, double spacing) {
  const Entry& found = entry(name);
  return found.make(with_defaults(found.description.parameters, settings), spacing);
}

bool is_centred_on_points(std::string_view name) { return entry(name).is_centred_on_points; }

}  // namespace moire
