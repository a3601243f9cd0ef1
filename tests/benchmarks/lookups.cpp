#include "lookups.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <moire/random.h>

#include "interleaved.h"
#include "photograph_plane.h"
#include "run/speed.h"
#include "sampling/lookups.h"

namespace moire::benchmark {

namespace {

constexpr int rounds = 25;
constexpr std::size_t green = 1;

struct Contender {
  std::string name, lookup;
  std::vector<std::pair<std::string, Value>> settings;
  const char* measured_before;  // rmse and ns of a prototype, or of OpenImageIO, on another day
};

std::vector<Contender> contenders() {
  const auto text = [](const char* t) { return Value(std::string(t)); };
  const auto bilinear = std::pair<std::string, Value>{"oiio.interpolation", text("bilinear")};
  const auto probes = [](std::int64_t n) {
    return std::vector<std::pair<std::string, Value>>{{"anisotropic.probes", n}};
  };
  return {
      {"nearest", "nearest", {}, ".0421    5"},
      {"bilinear", "bilinear", {}, ".0401    6"},
      {"mip, nearest level and texel",
       "mipmap",
       {{"mipmap.between", text("nearest")}, {"mipmap.within", text("nearest")}},
       ".0291   12"},
      {"mip, nearest level", "mipmap", {{"mipmap.between", text("nearest")}}, ".0237   19"},
      {"trilinear, max", "mipmap", {}, ".0227   32"},
      {"trilinear, max, bias -1", "mipmap", {{"mipmap.bias", -1.0}}, ".0141   32"},
      {"trilinear, area", "mipmap", {{"mipmap.level", text("area")}}, ".0173   27"},
      {"trilinear, min", "mipmap", {{"mipmap.level", text("min")}}, ".0320   22"},
      {"anisotropic 4", "anisotropic", probes(4), ".0083   66"},
      {"anisotropic 16", "anisotropic", probes(16), ".0036  116"},
      {"anisotropic 64", "anisotropic", probes(64), ".0030  163"},
      {"oiio, trilinear", "oiio", {{"oiio.mip", text("trilinear")}}, ".0212  234"},
      {"oiio, anisotropic 16, bilinear", "oiio", {{"oiio.anisotropic", std::int64_t{16}}, bilinear}, ".0112  931"},
      {"oiio, as it comes", "oiio", {}, ".0128 1317"},
      {"oiio, anisotropic 64, width .65",
       "oiio",
       {{"oiio.anisotropic", std::int64_t{64}}, {"oiio.width", 0.65}},
       ".0041    -"},
  };
}

std::unique_ptr<Lookup> made(const Contender& contender) {
  Settings settings;
  for (const NamedSummary& lookup : lookups()) {
    if (lookup.name == contender.lookup) settings = Settings(lookup.parameters);
  }
  for (const auto& [name, value] : contender.settings) settings.set(name, value);
  return make_lookup(contender.lookup, settings);
}

// One lookup in the middle of every pixel.
void look(const PhotographPlane& plane, const Lookup* lookup, Tally& tally) {
  tally.reset(plane.points().size());
  std::size_t slot = 0;
  for (const SurfacePoint& point : plane.points()) {
    if (lookup) {
      lookup->deposit(point, plane.texture(), 1, tally, slot++);
    } else {
      const Hit hit = plane.texture().texel(0, static_cast<std::int64_t>(std::floor(point.s)),
                                            static_cast<std::int64_t>(std::floor(point.t)));
      tally.add(slot++, hit.element, 1, hit.color);
    }
  }
}

// Green, as in the table it is read beside; rows are counted from the horizon.
double rmse(const Tally& tally, const std::vector<std::array<double, 3>>& exact, int first_row, int last_row) {
  double sum = 0;
  const auto begin = static_cast<std::size_t>((first_row - 1) * PhotographPlane::columns);
  const auto end = static_cast<std::size_t>(last_row * PhotographPlane::columns);
  for (std::size_t k = begin; k < end; ++k) {
    const double error = tally.sum(k).g / tally.sum(k).weight - exact[k][green];
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(end - begin));
}

// The exact averages beside many points of a few pixels, whose mean is off by about noise / points.
void check_reference(const PhotographPlane& plane, const std::vector<std::array<double, 3>>& exact) {
  constexpr int pixels = 64, side = 256;
  double worst = 0;
  for (int n = 0; n < pixels; ++n) {
    const int row = 8 + static_cast<int>(random({.x = n}, 0, 0) * 240);
    const int column = static_cast<int>(random({.x = n}, 0, 1) * PhotographPlane::columns);
    double sum = 0;
    for (int k = 0; k < side * side; ++k) {
      const double below = row + (k / side + 0.5) / side;
      const double aside = column - PhotographPlane::columns / 2 + (k % side + 0.5) / side;
      sum += static_cast<double>(
          plane.texture()
              .texel(0, static_cast<std::int64_t>(std::floor(aside * PhotographPlane::height / below)),
                     static_cast<std::int64_t>(PhotographPlane::height * PhotographPlane::focal / below))
              .color.g);
    }
    const auto at = static_cast<std::size_t>((row - 1) * PhotographPlane::columns + column);
    worst = std::max(worst, std::abs(sum / (side * side) - exact[at][green]));
  }
  fmt::print("  exact averages against {} x {} points in {} pixels: farthest apart {:.1e}\n", side, side, pixels,
             worst);
}

}  // namespace

void run_lookups() {
  const PhotographPlane plane;
  const auto exact = plane.exact();
  fmt::print(
      "Lookups: aerial photograph on a plane, {} x {} pixels below the horizon, one lookup a pixel; rmse of green "
      "against exact averages; tenth percentile of {} rounds, one thread.\n",
      PhotographPlane::columns, PhotographPlane::rows, rounds);
  check_reference(plane, exact);

  const std::vector<Contender> all = contenders();
  std::vector<std::unique_ptr<Lookup>> lookups;
  for (const Contender& contender : all) lookups.push_back(made(contender));
  Tally tally(plane.points().size(), false);
  std::vector<Work> works;
  for (std::size_t k = 0; k < all.size(); ++k) {
    works.push_back({all[k].name, [&, k] { look(plane, lookups[k].get(), tally); }});
  }
  const auto times = interleaved(works, rounds);
  fmt::print("  {:<32} {:>7} {:>7} {:>7} {:>7} {:>6}   measured before: all, ns\n", "rmse in rows", "4-15", "16-63",
             "64-127", "all", "ns");
  for (std::size_t k = 0; k < all.size(); ++k) {
    works[k].run();
    const double ns = 1e6 * quantile(times[k].ms, 0.1) / static_cast<double>(plane.points().size());
    fmt::print("  {:<32} {:7.4f} {:7.4f} {:7.4f} {:7.4f} {:6.0f}   {}\n", all[k].name, rmse(tally, exact, 4, 15),
               rmse(tally, exact, 16, 63), rmse(tally, exact, 64, 127), rmse(tally, exact, 1, PhotographPlane::rows),
               ns, all[k].measured_before);
  }
}

}  // namespace moire::benchmark
