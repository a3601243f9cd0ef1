// Footprints of blocks made by hand.
#include <catch2/catch_test_macros.hpp>

#include "pictures/footprint_plan.h"
#include "pictures/registry.h"

namespace moire::test {

namespace {

using namespace footprint_colors;

constexpr Element a = texel_element(0, 0, 0), b = texel_element(0, 1, 0), c = texel_element(0, 3, 0);
constexpr ImageSize image{10, 6};

Settings window(const char* in, PixelArea area) {
  Settings settings(footprint_description.parameters);
  settings.set("in", std::string(in));
  settings.set("window.x", std::int64_t{area.x0});
  settings.set("window.y", std::int64_t{area.y0});
  settings.set("window.width", std::int64_t{area.width});
  settings.set("window.height", std::int64_t{area.height});
  return settings;
}

struct Deposit {
  int x, y;
  Element element;
  double weight;
};
using Deposits = std::vector<Deposit>;

// What a window shows of an image with these fragments; all other pixels see something else entirely.
Drawing footprint(const char* in, PixelArea area, const Deposits& own, const Deposits& exact) {
  const auto pass = make_footprint(window(in, area), {image, 1});
  const auto [x0, width] = pass->needs().columns;
  const auto block = [&](const Deposits& deposits, Element elsewhere) {
    PixelBlock result({x0, 0, width, image.height}, true);
    for (int x = x0; x < x0 + width; ++x) {
      for (int y = 0; y < image.height; ++y) {
        if (y < area.y0 || y >= area.y0 + area.height) result.add(result.slot(x, y), elsewhere, 1, {});
      }
    }
    for (const Deposit& d : deposits) result.add(result.slot(d.x, d.y), d.element, d.weight, {});
    return result;
  };
  const MergedBlock truth(block(exact, texel_element(0, 70, 70)));
  pass->see({0, block(own, texel_element(0, 80, 80)), nullptr, &truth});
  return pass->finish();
}

// From the bottom of pixel (x, y) of the window: rows that are blue, and rows whose last column is orange. All else is
// red, or blue beside a leak that ends lower.
struct Bars {
  int sampled = 0, leaked = 0;
  friend bool operator==(const Bars&, const Bars&) = default;
};

Bars bars(const Picture& picture, int x, int y) {
  Bars found;
  for (int row = 0; row < 8; ++row) {
    const auto at = [&](int column) {
      return picture.pixels[static_cast<std::size_t>((8 * y + 7 - row) * picture.size.width + 8 * x + column)];
    };
    for (int column = 0; column < 7; ++column) CHECK(at(column) == (at(0) == sampled ? sampled : missed));
    CHECK(at(7) == (at(7) == leaked ? leaked : at(0)));
    // Bars stand on the bottom and have no gaps.
    if (at(0) == sampled) CHECK(found.sampled++ == row);
    if (at(7) == leaked) CHECK(found.leaked++ == row);
  }
  return found;
}

}  // namespace

TEST_CASE("on the image, bars are as high as the visible weight that is sampled and the weight that leaks") {
  const Drawing drawing = footprint("image", {4, 2, 3, 2},
                                    {
                                        {4, 2, a, 1},  // the smaller of two
                                        {4, 3, a, 2},
                                        {4, 3, b, 1},  // both, however unevenly
                                        {5, 2, c, 1},  // another altogether
                                        {5, 3, a, 3},
                                        {5, 3, c, 1},           // a quarter leaks
                                        {6, 2, background, 5},  // sky, rightly
                                                                // (6, 3): nothing at all
                                    },
                                    {
                                        {4, 2, a, 0.25},
                                        {4, 2, b, 0.75},
                                        {4, 3, a, 0.5},
                                        {4, 3, b, 0.5},
                                        {5, 2, a, 1},
                                        {5, 3, a, 1},
                                        {6, 2, background, 1},
                                        {6, 3, a, 1},
                                    });
  REQUIRE(drawing.picture.size == ImageSize{24, 16});
  CHECK(bars(drawing.picture, 0, 0) == Bars{2, 0});
  CHECK(bars(drawing.picture, 0, 1) == Bars{8, 0});
  CHECK(bars(drawing.picture, 1, 0) == Bars{0, 8});
  CHECK(bars(drawing.picture, 1, 1) == Bars{8, 2});
  CHECK(bars(drawing.picture, 2, 0) == Bars{8, 0});
  CHECK(bars(drawing.picture, 2, 1) == Bars{0, 0});
  // Missed .75 + 1 + 1 of six, leaked 1 + .25.
  CHECK(drawing.caption ==
        "Window of 3 x 2 pixels at (4, 2), magnified 8 times. Each pixel, from its bottom: blue the visible weight "
        "that is sampled, red what is missed (mean 0.458); orange, at the right: weight given to what cannot be "
        "seen there (mean 0.208)");
}

TEST_CASE("where all is sampled nothing is missed, however the weights' sum is rounded") {
  for (int count = 1; count <= 50; ++count) {
    CAPTURE(count);
    Deposits all;
    for (int k = 0; k < count; ++k) all.push_back({0, 0, texel_element(0, k, 0), 0.1});
    const std::string caption = footprint("image", {0, 0, 1, 1}, all, all).caption;
    CHECK(caption.find("missed (mean 0.000)") != std::string::npos);
  }
}

TEST_CASE("in plan, a footprint is that of all elements of the window, each once") {
  const Drawing drawing =
      footprint("plan", {4, 2, 2, 2}, {{4, 2, a, 1}, {5, 2, a, 1}, {5, 3, background, 1}},
                {{4, 2, a, 0.5}, {4, 2, c, 0.5}, {5, 2, a, 1}, {4, 3, c, 1}, {5, 3, background, 1}});
  const FootprintPlan expected = footprint_plan({a, c}, {a});
  CHECK(drawing.picture.size == expected.picture.size);
  CHECK(drawing.picture.pixels == expected.picture.pixels);
  CHECK(drawing.caption ==
        "Window of 2 x 2 pixels at (4, 2), in plan. Blue: 1 sampled; red: 1 visible and missed (M/V 0.50); green: 2 "
        "hidden among them");
  CHECK(footprint("plan", {0, 0, 1, 1}, {{0, 0, b, 1}}, {{0, 0, a, 1}}).caption ==
        "Window of 1 x 1 pixels at (0, 0), in plan. Blue: 0 sampled; red: 1 visible and missed (M/V 0.00); green: 0 "
        "hidden among them; orange: 1 sampled though hidden");
}

TEST_CASE("a window that sees nothing but background has no ratio") {
  const Drawing drawing = footprint("plan", {0, 0, 1, 1}, {{0, 0, background, 1}}, {{0, 0, background, 1}});
  CHECK(drawing.picture.size == ImageSize{1, 1});
  CHECK(drawing.caption ==
        "Window of 1 x 1 pixels at (0, 0), in plan. Blue: 0 sampled; red: 0 visible and missed; green: 0 hidden among "
        "them");
}

TEST_CASE("a footprint asks for the fragments of its window's columns, and for the exact ones") {
  for (const char* in : {"plan", "image"}) {
    const Needs needs = make_footprint(window(in, {3, 1, 4, 2}), {image, 9})->needs();
    CHECK(needs.columns == Columns{3, 4});
    CHECK(needs.fragments);
    CHECK(needs.exact);
    CHECK_FALSE(needs.every_frame);
    CHECK_FALSE(needs.reference);
    CHECK_FALSE(needs.of_reference);
  }
}

TEST_CASE("only a footprint in plan needs a scene whose elements are texels") {
  CHECK(footprint_description.asks(window("plan", {0, 0, 1, 1})) == Questions::surface);
  CHECK(footprint_description.asks(window("image", {0, 0, 1, 1})) == Questions::none);
}

TEST_CASE("a footprint's window lies in the image, and is small enough to be magnified") {
  const auto problem = [](const char* in, PixelArea area, ImageSize size = image) {
    return footprint_description.problem(window(in, area), {size, 1});
  };
  CHECK(problem("plan", {0, 0, 10, 6}).empty());
  CHECK(problem("image", {9, 5, 1, 1}).empty());
  CHECK(problem("plan", {1, 0, 10, 6}) == "its window of 10 x 6 pixels at (1, 0) leaves the image of 10 x 6");
  CHECK(problem("image", {0, 5, 1, 2}) == "its window of 1 x 2 pixels at (0, 5) leaves the image of 10 x 6");
  CHECK(problem("image", {0, 0, 512, 512}, {4000, 4000}).empty());
  CHECK(problem("plan", {0, 0, 4000, 4000}, {4000, 4000}).empty());
  CHECK(problem("image", {0, 0, 16, 513}, {4000, 4000}) ==
        "shows a window of 16 x 513 pixels magnified 8 times; at most 512 x 512 can be");
}

}  // namespace moire::test
