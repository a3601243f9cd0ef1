// Whole drawings: the ten of data:cartoon, the built-in one, and very many layers.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <map>

#include <moire/random.h>

#include "own/own_cartoon.h"
#include "plugins/cartoon/brute_force.h"
#include "plugins/cartoon/svg_text.h"

namespace moire::test {

TEST_CASE("the ten drawings of data:cartoon load with all their layers") {
  const char* const data = std::getenv("MOIRE_DATA");
  if (!data || !std::filesystem::exists(std::filesystem::path(data) / "cartoon")) {
    SKIP("MOIRE_DATA is not set or has no folder cartoon");
  }
  // As counted in the data's README.md.
  const std::map<std::string, std::size_t> layers{{"cup", 9},       {"dinosaur", 21}, {"fish", 21}, {"house", 37},
                                                  {"tractor", 48},  {"corn", 199},    {"frog", 72}, {"cats", 127},
                                                  {"pumpkin", 144}, {"lemon", 99}};
  for (const auto& [name, count] : layers) {
    CAPTURE(name);
    const std::string file = std::string(data) + "/cartoon/" + name + ".svg";
    CHECK(cartoon::read_drawing_file(file, cartoon::Unmodelled::refuse).layers.size() == count);
  }
}

TEST_CASE("the built-in cartoon has many layers, and something of each is seen") {
  const cartoon::Drawing drawing = cartoon::own_cartoon();
  CHECK(drawing.layers.size() >= 40);
  constexpr ImageSize size{240, 180};
  CHECK(drawing.view_box == cartoon::Box{0, 0, size.width, size.height});
  const auto frame = frame_of(drawing, size);
  std::vector<bool> seen(drawing.layers.size() + 1);
  for (int x = 0; x < 4 * size.width; ++x) {
    std::vector<SamplePoint> column;
    for (int y = 4 * size.height - 1; y >= 0; --y) column.push_back({(x + 0.5) / 4, (y + 0.5) / 4});
    for (const Element element : together(*frame, column)) seen[element] = true;
  }
  CHECK_FALSE(seen[background]);
  for (std::size_t k = 1; k < seen.size(); ++k) {
    CAPTURE(k);
    CHECK(seen[k]);
  }
}

// A million of them, each a small path, take 10 s (JSON) to 20 s (SVG) and 1.8 GB, picture of 1024 x 1024 included.
TEST_CASE("many layers, in SVG and in JSON, are the same drawing") {
  constexpr int count = 20000;
  std::string svg = "<svg viewBox='0 0 100 100'>", json = "{\"view_box\": [0, 0, 100, 100], \"layers\": [";
  for (int k = 0; k < count; ++k) {
    const double x = 100 * random({.x = k}, 0, 0), y = 100 * random({.x = k}, 0, 1), r = random({.x = k}, 0, 2);
    const std::string color = fmt::format("#{:06x}", k);
    svg += fmt::format("<path fill='{}' d='M{} {}L{} {}L{} {}Z'/>\n", color, x, y, x + r, y, x, y + r);
    json += fmt::format("{}{{\"color\": \"{}\", \"contours\": [[[{}, {}], [{}, {}], [{}, {}]]]}}\n", k ? ", " : "",
                        color, x, y, x + r, y, x, y + r);
  }
  const cartoon::Drawing one = read(svg + "</svg>"), other = read(json + "]}");
  CHECK(one.layers.size() == count);
  CHECK(one.points == other.points);
  CHECK(one.verbs == other.verbs);
  bool same_colors = other.layers.size() == count;
  for (std::size_t k = 0; same_colors && k < count; ++k) same_colors = one.layers[k].color == other.layers[k].color;
  CHECK(same_colors);
}

}  // namespace moire::test
