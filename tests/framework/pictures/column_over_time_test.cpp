#include <catch2/catch_test_macros.hpp>

#include "pictures/registry.h"

namespace moire::test {

namespace {

Settings column(std::int64_t number) {
  Settings settings(column_over_time_description.parameters);
  settings.set("column", number);
  return settings;
}

// What pixel (x, y) of a frame looks like.
Color look(int frame, int x, int y) {
  return {static_cast<float>(frame), static_cast<float>(x), static_cast<float>(y)};
}

}  // namespace

TEST_CASE("column x of the picture is the image's column at frame x, upright") {
  constexpr Extent extent{{7, 3}, 5};
  const auto pass = make_column_over_time(column(2), extent);
  const auto [x0, width] = pass->needs().columns;
  for (int frame = 0; frame < extent.frames; ++frame) {
    PixelBlock block({x0, 0, width, extent.image.height}, false);
    for (int y = 0; y < extent.image.height; ++y) block.add(block.slot(2, y), 1, 0.5, look(frame, 2, y));
    pass->see({frame, block, nullptr, nullptr});
  }
  const Drawing drawing = pass->finish();
  REQUIRE(drawing.picture.size == ImageSize{5, 3});
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      CAPTURE(x, y);
      CHECK(drawing.picture.pixels[static_cast<std::size_t>(5 * y + x)] == look(x, 2, y));
    }
  }
  CHECK(drawing.caption == "Column 2 over 5 frames, time from left to right");
}

TEST_CASE("a column over time asks for its column's colours of every frame, of the reference too") {
  const Needs needs = make_column_over_time(column(-1), {{7, 3}, 5})->needs();
  CHECK(needs.columns == Columns{3, 1});
  CHECK(needs.every_frame);
  CHECK(needs.of_reference);
  CHECK_FALSE(needs.fragments);
  CHECK_FALSE(needs.reference);
  CHECK_FALSE(needs.exact);
}

TEST_CASE("a column over time takes a column of the image, and a number of frames that a picture can be wide") {
  const auto problem = [](std::int64_t number, int frames) {
    return column_over_time_description.problem(column(number), {{7, 3}, frames});
  };
  CHECK(problem(6, 2).empty());
  CHECK(problem(-1, 16384).empty());
  CHECK(problem(7, 2) == "shows column 7; the image has columns 0 to 6");
  CHECK(problem(0, 1) == "shows frames side by side; give \"frames\" a \"count\" of 2 or more");
  CHECK(problem(0, 16385) ==
        "shows frames side by side, and there are 16385; give \"frames\" a \"count\" of 16384 or less");
}

}  // namespace moire::test
