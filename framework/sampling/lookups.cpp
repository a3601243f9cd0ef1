#include "sampling/lookups.h"

#include <array>

#include "sampling/options.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter bias(std::string_view name) {
  return real(name, 0, -16, 16, "levels", "added to the level: below 0 is sharper and aliases more");
}
constexpr Parameter footprint(std::string_view name) {
  return choice(name, "sample", "sample pixel",
                "what is filtered over: as much of the pixel as a sample stands for, or all of it for every sample");
}

constexpr Parameter mipmap_parameters[] = {
    choice("mipmap.level", "max", "max min area",
           "texels of which size: as long as the longer derivative, the shorter one, or the root of their area"),
    choice("mipmap.between", "trilinear", "trilinear nearest", "of the two levels about that size, or of the nearest"),
    choice("mipmap.within", "bilinear", "bilinear nearest", "the four nearest texels of a level, or the nearest"),
    bias("mipmap.bias"),
    footprint("mipmap.footprint"),
};
constexpr Parameter anisotropic_parameters[] = {
    integer("anisotropic.probes", 16, 1, 64, "", "most reads of a footprint; beyond that they get wider"),
    bias("anisotropic.bias"),
    footprint("anisotropic.footprint"),
};
constexpr Parameter oiio_parameters[] = {
    choice("oiio.mip", "anisotropic", "anisotropic trilinear one_level none", "OpenImageIO's mip mode"),
    choice("oiio.interpolation", "smart_bicubic", "smart_bicubic bicubic bilinear closest",
           "within a level; smart: bicubic where texels are enlarged"),
    integer("oiio.anisotropic", 32, 1, 1024, "", "largest ratio of a footprint's axes"),
    real("oiio.width", 1, 0.01, 16, "", "what derivatives are multiplied by (swidth, twidth)"),
    footprint("oiio.footprint"),
};

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
    Entry{
        {"mipmap", "averages in squares, made beforehand (Williams 1983): blurs where a footprint is longer than wide",
         mipmap_parameters},
        make_mipmap},
    Entry{{"anisotropic", "several reads of the same averages in a row along the footprint's longer side",
           anisotropic_parameters},
          make_anisotropic},
    Entry{{"oiio", "OpenImageIO's TextureSystem; hides its texels: fragments, leak and coverage mean nothing",
           oiio_parameters},
          make_oiio},
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
