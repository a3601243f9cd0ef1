// Test patterns whose pixels are known exactly: waves, edges, disks, stripes, cells.
#include <algorithm>
#include <array>

#include <moire/plugin.h>

#include "kinds/kinds.h"
#include "random_waves.h"

namespace pattern {

namespace {

using namespace moire::parameter;
using moire::Settings;

constexpr moire::Parameter parameters[] = {
    choice("kind", "zone_plate", "zone_plate sinusoids wave grating edge disk blob star checkerboard",
           "cos(a r^2); many sinusoids of random frequencies; one or two of given ones; stripes; a straight edge; a "
           "disk; a Gaussian blob; Siemens' star; a checkerboard"),
    color("dark", "#000000", "what is dark, outside or low"),
    color("light", "#ffffff", "what is light, inside or high; between the two, light is mixed"),
    real("view.x", 0, -1e5, 1e5, "pixels", "moves the pattern right; of tiles, what is in each").per_frame(),
    real("view.y", 0, -1e5, 1e5, "pixels", "moves it down").per_frame(),
    real("mean", 0.5, 0, 1, "", "of zone_plate, sinusoids, wave: the grey about which they swing, 0 dark, 1 light"),
    real("amplitude", 0.5, 0, 10, "", "of zone_plate, wave; sums that leave 0 .. 1 go on beyond the two colours")
        .per_frame(),
    real("peak_frequency", 1, 1e-3, 16, "cycles/pixel",
         "of zone_plate: the largest frequency along x or y, reached at the ends of the image's longer side"),
    integer("components_in", 40, 0, 10000, "", "of sinusoids: those that pixels can show, up to .45 cycles a pixel"),
    integer("components_out", 40, 0, 10000, "", "of sinusoids: those that they cannot, .55 to 3 cycles a pixel"),
    real("rms", 0.1, 0, 10, "", "of sinusoids: of their sum, about its mean"),
    integer("seed", 1, 0, 1000000000, "", "of sinusoids and tiles: chooses the random numbers"),
    real("frequency", 0.1, 0, 64, "cycles/pixel", "of wave, grating").per_frame(),
    real("angle_deg", 0, -1e6, 1e6, "degrees",
         "clockwise: the direction in which wave and grating go on and into which an edge is light; turns star and "
         "checkerboard")
        .per_frame(),
    real("phase_deg", 0, -1e6, 1e6, "degrees", "of wave, grating: in the middle of the image").per_frame(),
    real("second_amplitude", 0, 0, 10, "", "of wave: of a second one, added; its phase is 0 in the middle").per_frame(),
    real("second_frequency", 0.2, 0, 64, "cycles/pixel", "of wave").per_frame(),
    real("second_angle_deg", 90, -1e6, 1e6, "degrees", "of wave").per_frame(),
    real("duty", 0.5, 0, 1, "", "of grating: the part of a period that is light").per_frame(),
    real("offset", 0, -1e5, 1e5, "pixels", "of edge: how far it lies from the middle").per_frame(),
    real("radius", 20.3, 1e-3, 1e5, "pixels", "of disk").per_frame(),
    real("sigma", 10, 0.02, 1e3, "pixels", "of blob: standard deviation").per_frame(),
    integer("spokes", 36, 2, 1000, "", "of star: light ones"),
    real("cell", 8, 0.05, 1e5, "pixels", "of checkerboard: a cell's side").per_frame(),
    integer("tile", 0, 0, 4096, "pixels",
            "of edge, disk, blob: side of the squares that each have one of their own, moved by a random part of a "
            "pixel; 0: one for the whole image. Filters wider than a pixel need 0"),
    choice("angles", "one", "one any", "of edge: angle_deg, or a random one in each tile"),
};

Look look_of(const Settings& s, moire::ImageSize size) {
  return {size,
          {s.real("view.x"), s.real("view.y")},
          {moire::parse_color(s.text("dark")), moire::parse_color(s.text("light"))}};
}

// A wave that has this phase in the middle of the pattern.
moire::Sinusoid wave_about(moire::Point middle, double amplitude, moire::Point frequency, double phase_deg) {
  constexpr double turn = 2 * std::numbers::pi;
  const double cycles = phase_deg / 360 - dot(frequency, middle);
  return {amplitude, frequency.x, frequency.y, turn * (cycles - std::floor(cycles))};
}

std::unique_ptr<moire::Frame> sinusoids(const Settings& s, const Look& look, const Tiles&) {
  auto waves =
      random_waves({static_cast<int>(s.integer("components_in")), static_cast<int>(s.integer("components_out")),
                    s.real("rms"), static_cast<std::uint64_t>(s.integer("seed"))},
                   look.size);
  for (moire::Sinusoid& wave : waves) wave.phase -= 2 * std::numbers::pi * dot({wave.fx, wave.fy}, look.view);
  return make_waves(look, s.real("mean"), std::move(waves));
}

std::unique_ptr<moire::Frame> wave(const Settings& s, const Look& look, const Tiles&) {
  std::vector<moire::Sinusoid> waves{wave_about(
      look.middle(), s.real("amplitude"), s.real("frequency") * direction(s.real("angle_deg")), s.real("phase_deg"))};
  if (s.real("second_amplitude") > 0) {
    waves.push_back(wave_about(look.middle(), s.real("second_amplitude"),
                               s.real("second_frequency") * direction(s.real("second_angle_deg")), 0));
  }
  return make_waves(look, s.real("mean"), std::move(waves));
}

struct Kind {
  std::string_view name;
  std::unique_ptr<moire::Frame> (*make)(const Settings&, const Look&, const Tiles&);
  bool has_spectrum = false, has_tiles = false;
};

constexpr std::array kinds{
    Kind{"zone_plate",
         [](const Settings& s, const Look& look, const Tiles&) {
           return make_zone_plate(look, s.real("mean"), s.real("amplitude"), s.real("peak_frequency"));
         },
         true},
    Kind{"sinusoids", sinusoids, true},
    Kind{"wave", wave, true},
    Kind{"grating",
         [](const Settings& s, const Look& look, const Tiles&) {
           return make_grating(look, {s.real("frequency"), s.real("angle_deg"), s.real("phase_deg"), s.real("duty")});
         }},
    Kind{"edge",
         [](const Settings& s, const Look& look, const Tiles& tiles) {
           return make_edges(look, {s.real("angle_deg"), s.text("angles") == "any"}, s.real("offset"), tiles);
         },
         false, true},
    Kind{"disk",
         [](const Settings& s, const Look& look, const Tiles& tiles) {
           return make_disks(look, s.real("radius"), tiles);
         },
         false, true},
    Kind{"blob",
         [](const Settings& s, const Look& look, const Tiles& tiles) {
           return s.integer("tile") > 0 ? make_tiled_blobs(look, s.real("sigma"), tiles)
                                        : make_blobs(look, s.real("sigma"));
         },
         false, true},
    Kind{"star",
         [](const Settings& s, const Look& look, const Tiles&) {
           return make_star(look, static_cast<int>(s.integer("spokes")), s.real("angle_deg"));
         }},
    Kind{"checkerboard", [](const Settings& s, const Look& look,
                            const Tiles&) { return make_checkerboard(look, s.real("cell"), s.real("angle_deg")); }},
};

const Kind& kind_of(const Settings& settings) {
  return *std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == settings.text("kind"); });
}

class Pattern final : public moire::Scene {
 public:
  std::unique_ptr<moire::Frame> frame(const Settings& settings, moire::ImageSize size) const override {
    const Look look = look_of(settings, size);
    const Tiles tiles(look, static_cast<int>(settings.integer("tile")),
                      static_cast<std::uint64_t>(settings.integer("seed")));
    return kind_of(settings).make(settings, look, tiles);
  }
};

moire::Questions answers(const Settings& settings) {
  using enum moire::Questions;
  return points | averages | (settings.integer("tile") == 0 ? filtered_averages : none) |
         (kind_of(settings).has_spectrum ? spectrum : none);
}

std::string problem(const Settings& settings) {
  if (settings.integer("tile") > 0 && !kind_of(settings).has_tiles)
    return "tile is for edge, disk and blob; a " + settings.text("kind") + " has none: 0";
  if (settings.text("angles") == "any" && settings.integer("tile") == 0)
    return "angles of \"any\" are those of tiles, of which there are none (tile is 0); 1 or more";
  return {};
}

}  // namespace

}  // namespace pattern

MOIRE_SCENE(pattern, "1.0.0",
            (moire::ScenePlugin{
                .summary = "Test patterns whose pixels are known in closed form: waves, edges, disks, stripes, cells.",
                .source = "Mitchell 1996 (edges, disks); Siemens' star, zone plate",
                .parameters = pattern::parameters,
                .answers = pattern::answers,
                .problem = pattern::problem,
                .make = [](const moire::Settings&) -> std::unique_ptr<moire::Scene> {
                  return std::make_unique<pattern::Pattern>();
                },
            }))
