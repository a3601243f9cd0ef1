#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "pictures/registry.h"

namespace moire::test {

namespace {

constexpr Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, grey{0.5F, 0.5F, 0.5F};
constexpr int side = 200;

struct Band {
  int height;
  Color color;
  friend bool operator==(const Band&, const Band&) = default;
};

Settings pixel(std::int64_t x, std::int64_t y, const char* over) {
  Settings settings(enlarged_pixel_description.parameters);
  settings.set("x", x);
  settings.set("y", y);
  settings.set("over", std::string(over));
  return settings;
}

using Deposits = std::vector<Fragment>;

// Shows the pass a frame in which the pixel has these fragments, and all other pixels one of grey.
void show(PicturePass& pass, int frame, int x, int y, int image_height, const Deposits& deposits,
          Blend blend = Blend::linear) {
  const auto [x0, width] = pass.needs().columns;
  PixelBlock block({x0, 0, width, image_height}, true, Blocks::columns, blend);
  for (int row = 0; row < image_height; ++row) {
    if (row != y) block.add(block.slot(x, row), 99, 1, grey);
  }
  for (const Fragment& f : deposits) block.add(block.slot(x, y), f.element, f.weight, f.color);
  pass.see({frame, block, nullptr, nullptr});
}

// The bands of one column of a picture, from its bottom.
std::vector<Band> bands(const Picture& picture, int column) {
  std::vector<Band> result;
  for (int row = picture.size.height - 1; row >= 0; --row) {
    const Color c = picture.pixels[static_cast<std::size_t>(row * picture.size.width + column)];
    if (result.empty() || result.back().color != c) result.push_back({0, c});
    ++result.back().height;
  }
  return result;
}

}  // namespace

TEST_CASE("an enlarged pixel has its fragments from bottom to top in their order, each as high as its share") {
  const auto pass = make_enlarged_pixel(pixel(3, 1, "still"), {{5, 4}, 1});
  // Shares 1/4, 1/2, 1/4; one element twice, as it was deposited; weights of any unit.
  show(*pass, 0, 3, 1, 4, {{7, 2, red}, {8, 4, green}, {7, 2, blue}});
  const Drawing drawing = pass->finish();
  REQUIRE(drawing.picture.size == ImageSize{side, side});
  for (const int column : {0, 99, side - 1}) {
    CHECK(bands(drawing.picture, column) == std::vector<Band>{{50, red}, {100, green}, {50, blue}});
  }
  CHECK(drawing.caption == "Pixel (3, 1): 3 fragments");
}

TEST_CASE("fragments of code values are drawn in the light that they stand for") {
  const auto pass = make_enlarged_pixel(pixel(0, 0, "still"), {{1, 1}, 1});
  show(*pass, 0, 0, 0, 1, {{1, 1, {0.5F, 0, 1}}, {2, 1, {0, 0.04F, 0}}}, Blend::as_stored);
  const auto light = [](float code) { return static_cast<float>(srgb_to_linear(code)); };
  CHECK(bands(pass->finish().picture, 0) == std::vector<Band>{{100, {light(0.5F), 0, 1}}, {100, {0, light(0.04F), 0}}});
}

TEST_CASE("a row of an enlarged pixel belongs to what its middle lies in, and all rows are filled") {
  for (const int count : {1, 3, 7, 199, 200, 201, 1000}) {
    CAPTURE(count);
    const auto pass = make_enlarged_pixel(pixel(0, 0, "still"), {{1, 1}, 1});
    Deposits deposits;
    for (int k = 0; k < count; ++k) {
      deposits.push_back({static_cast<Element>(k + 1), 0.1, {static_cast<float>(k), 0, 0}});
    }
    show(*pass, 0, 0, 0, 1, deposits);
    const Picture picture = pass->finish().picture;
    for (int row = 0; row < side; ++row) {
      const float found = picture.pixels[static_cast<std::size_t>((side - 1 - row) * side)].r;
      const double place = (row + 0.5) / side * count;  // in fragments from the bottom
      // On a border, sums of tenths fall on either side of it.
      CHECK(found >= std::floor(place - 1e-6));
      CHECK(found <= std::floor(place + 1e-6));
    }
  }
}

TEST_CASE("over time, an enlarged pixel has a column for each frame") {
  const auto pass = make_enlarged_pixel(pixel(0, 2, "time"), {{1, 3}, 3});
  show(*pass, 0, 0, 2, 3, {{7, 1, red}});
  show(*pass, 1, 0, 2, 3, {{7, 3, red}, {8, 1, blue}});
  show(*pass, 2, 0, 2, 3, {{8, 1, blue}, {7, 1, red}});
  const Drawing drawing = pass->finish();
  REQUIRE(drawing.picture.size == ImageSize{3, side});
  CHECK(bands(drawing.picture, 0) == std::vector<Band>{{200, red}});
  CHECK(bands(drawing.picture, 1) == std::vector<Band>{{150, red}, {50, blue}});
  CHECK(bands(drawing.picture, 2) == std::vector<Band>{{100, blue}, {100, red}});
  CHECK(drawing.caption == "Pixel (0, 2) over 3 frames, time from left to right");
}

TEST_CASE("a pixel in which nothing was deposited is black") {
  const auto pass = make_enlarged_pixel(pixel(0, 0, "still"), {{1, 1}, 1});
  show(*pass, 0, 0, 0, 1, {});
  const Drawing drawing = pass->finish();
  CHECK(bands(drawing.picture, 0) == std::vector<Band>{{200, {}}});
  CHECK(drawing.caption == "Pixel (0, 0): 0 fragments");
}

TEST_CASE("an enlarged pixel asks for the fragments of its column, over time those of every frame") {
  const Needs still = make_enlarged_pixel(pixel(-1, -1, "still"), {{5, 4}, 3})->needs();
  CHECK(still.columns == Columns{2, 1});
  CHECK(still.fragments);
  CHECK_FALSE(still.every_frame);
  CHECK_FALSE(still.of_reference);
  CHECK(make_enlarged_pixel(pixel(4, -1, "time"), {{5, 4}, 3})->needs().columns == Columns{4, 1});
  CHECK(make_enlarged_pixel(pixel(4, -1, "time"), {{5, 4}, 3})->needs().every_frame);
  // The middle row is meant by -1, too.
  CHECK(make_enlarged_pixel(pixel(-1, -1, "time"), {{5, 4}, 3})->finish().caption ==
        "Pixel (2, 2) over 3 frames, time from left to right");
}

TEST_CASE("an enlarged pixel lies in the image; over time there are frames") {
  const auto problem = [](std::int64_t x, std::int64_t y, const char* over, int frames) {
    return enlarged_pixel_description.problem(pixel(x, y, over), {{5, 4}, frames});
  };
  CHECK(problem(4, 3, "still", 1).empty());
  CHECK(problem(-1, -1, "time", 2).empty());
  CHECK(problem(5, 0, "still", 1) == "shows pixel (5, 0); the image has columns 0 to 4 and rows 0 to 3");
  CHECK(problem(-1, 4, "still", 1) == "shows pixel (2, 4); the image has columns 0 to 4 and rows 0 to 3");
  CHECK(problem(0, 0, "time", 1) == "shows frames side by side; give \"frames\" a \"count\" of 2 or more");
}

}  // namespace moire::test
