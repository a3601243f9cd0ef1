// The three exact integrators on hard pixels, each against exact arithmetic: never against each other.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <fmt/format.h>

#include "sanitized.h"
#include "support/hard_pixels.h"
#include "support/plugins.h"
#include "support/rational_area.h"

namespace moire::test {
namespace {

constexpr std::array integrators{"sweep", "prepared", "catmull"};

std::unique_ptr<Sampler> exact(const char* integrator) {
  return sampler("area", {{"method", std::string("exact")}, {"integrator", std::string(integrator)}});
}

// By element, as visible_areas() gives them.
std::vector<double> weights(const Content& content, std::size_t polygons) {
  std::vector<double> result(polygons + 1);
  for (const Fragment& f : content.fragments) result[f.element == background ? polygons : f.element - 1] += f.weight;
  return result;
}

// A sum of weights that differs from 1 by more than that is wrong whatever the coordinates.
constexpr double sum_bound = 1e-12;

struct Result {
  double error = 0;      // the largest of all elements
  double sum_error = 0;  // the largest of all pixels of the image
  double least = 1;      // of all fragments of the image
};

Result result(const HardPixel& pixel, const std::vector<double>& truth, const char* integrator) {
  const Rendered image = rendered(*exact(integrator), PolygonFrame(pixel.size, pixel.polygons));
  const std::vector<double> found = weights(image.at(pixel.x, pixel.y), pixel.polygons.size());
  Result result;
  for (std::size_t k = 0; k < truth.size(); ++k) result.error = std::max(result.error, std::abs(found[k] - truth[k]));
  for (const Content& content : image.pixels) {
    const std::vector<double> all = weights(content, pixel.polygons.size());
    double sum = -1;
    for (const double weight : all) sum += weight;
    for (const Fragment& f : content.fragments) result.least = std::min(result.least, f.weight);
    result.sum_error = std::max({result.sum_error, std::abs(sum), std::abs(content.weight - 1)});
  }
  return result;
}

// Of one kind; a line for each failure, with what is allowed in brackets.
std::string failures(std::string_view kind, int pixels) {
  std::string lines;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(pixels); ++seed) {
    const HardPixel pixel = hard_pixel(kind, seed);
    const std::vector<double> truth = visible_areas(pixel.polygons, pixel.x, pixel.y);
    const double bound = 1e-12 * std::max(1.0, pixel.largest_coordinate() / 1024);
    for (const char* integrator : integrators) {
      const auto [error, sum_error, least] = result(pixel, truth, integrator);
      if (error <= bound && sum_error <= sum_bound && least > 0) continue;
      lines += fmt::format(
          "{} of seed {}: {} is {:.2g} off ({:.2g}), its sums {:.2g} ({:.2g}), its least weight is {:.2g}\n", kind,
          seed, integrator, error, bound, sum_error, sum_bound, least);
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("each exact integrator gives each element its exact area in ten thousand hard pixels") {
  const auto kinds = hard_pixel_kinds();
  constexpr int thousand_layers = sanitized ? 2 : 20, all = sanitized ? 1000 : 10000;
  const int others = (all - thousand_layers) / (static_cast<int>(kinds.size()) - 1) + 1;
  for (const std::string_view kind : kinds) {
    CHECK(failures(kind, kind == "a thousand layers" ? thousand_layers : others) == "");
  }
}

// Where edges coincide, nothing but the polygons may decide which is summed first.
TEST_CASE("hard pixels have the same bits in blocks of single rows, and unrecorded") {
  for (const std::string_view kind : hard_pixel_kinds()) {
    for (std::uint64_t seed = 1; seed <= (kind == "a thousand layers" ? 2 : 60); ++seed) {
      const HardPixel pixel = hard_pixel(kind, seed);
      const PolygonFrame frame(pixel.size, pixel.polygons);
      for (const char* integrator : integrators) {
        CAPTURE(kind, seed, integrator);
        const Rendered image = rendered(*exact(integrator), frame);
        const Manner rows{.block_width = 1, .order = Blocks::rows};
        CHECK(first_difference(image, rendered(*exact(integrator), frame, nullptr, rows)) == "");
        CHECK(first_difference(image, rendered(*exact(integrator), frame, nullptr, {.recording = false})) == "");
      }
    }
  }
}

}  // namespace moire::test
