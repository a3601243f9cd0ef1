// The error metric must never call a picture better than it is: above all, not-a-number must not pass for small.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/metrics/measured.h"
#include "metrics/registry.h"

namespace moire::test {

using Catch::Approx;

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr Color black{}, half{0.5F, 0.5F, 0.5F};

Picture row(std::vector<Color> pixels) {
  const int width = static_cast<int>(pixels.size());
  return {{width, 1}, std::move(pixels)};
}

Settings settings(std::string_view name = "space", Value value = std::string("linear")) {
  Settings result(error_description.parameters);
  result.set(name, std::move(value));
  return result;
}

std::map<std::string, double> errors(std::vector<Color> picture, std::vector<Color> reference,
                                     const Settings& with = settings()) {
  return measured(*make_error(with), row(std::move(picture)), row(std::move(reference)));
}

}  // namespace

TEST_CASE("equal pictures have no error, in either space") {
  for (const char* space : {"linear", "srgb"}) {
    const auto found = errors({half, {0.1F, 2, 0}}, {half, {0.1F, 2, 0}}, settings("space", std::string(space)));
    CHECK(found == std::map<std::string, double>{
                       {"error.rmse", 0}, {"error.mae", 0}, {"error.max", 0}, {"error.bad_pixels", 0}});
  }
}

TEST_CASE("errors are levels of 1/255 over all pixels and channels") {
  // One channel of six is off by half of full scale: 127.5 levels.
  auto found = errors({{0.5F, 0, 0}, black}, {black, black});
  CHECK(found["error.rmse"] == Approx(127.5 / std::sqrt(6)).epsilon(1e-12));
  CHECK(found["error.mae"] == Approx(127.5 / 6).epsilon(1e-12));
  CHECK(found["error.max"] == 127.5);
  CHECK(found["error.bad_pixels"] == 0.5);

  // Too dark is as bad as too bright.
  CHECK(errors({black, black}, {{0.5F, 0, 0}, black}) == found);
}

TEST_CASE("in sRGB the code values are compared") {
  const auto light = [](double code) { return static_cast<float>(srgb_to_linear(code / 255)); };
  auto found = errors({{light(100), 0, 0}}, {{light(90), 0, 0}}, settings("space", std::string("srgb")));
  CHECK(found["error.max"] == Approx(10).epsilon(1e-4));  // light is a float
}

TEST_CASE("a pixel is bad if a channel is off by more than the bound, not by as much") {
  CHECK(errors({half}, {black}, settings("bad_above", 127.5))["error.bad_pixels"] == 0);
  CHECK(errors({half}, {black}, settings("bad_above", 127.4))["error.bad_pixels"] == 1);
}

TEST_CASE("not-a-number is shown as such, wherever it stands") {
  for (const std::size_t place : {0, 1, 2}) {
    for (const Color& broken : {Color{nan, 0, 0}, Color{0, nan, 0}, Color{0, 0, nan}}) {
      std::vector<Color> picture(3, half);
      picture[place] = broken;
      auto found = errors(picture, {half, half, half});
      CAPTURE(place, broken.r, broken.g);
      CHECK(std::isnan(found["error.rmse"]));
      CHECK(std::isnan(found["error.mae"]));
      CHECK(std::isnan(found["error.max"]));
      CHECK(found["error.bad_pixels"] == Approx(1.0 / 3).epsilon(1e-12));
    }
  }
}

TEST_CASE("error maps are made only where they are wanted") {
  const auto metric = make_error(settings("maps", false));
  measured(*metric, row({half, black}), row({black, black}));
  CHECK(metric->maps().empty());
}

TEST_CASE("error maps hold the mean over a pixel's channels, with and without sign") {
  const auto metric = make_error(settings("map_scale", 20.0));
  measured(*metric, row({{0.5F, 0, 0}, black}), row({black, {0, 0.25F, 0.5F}}));
  const std::vector<Map> maps = metric->maps();
  REQUIRE(maps.size() == 2);
  CHECK(maps[0].kind == "error_absolute");
  CHECK(maps[0].scale == 20);
  CHECK(maps[0].values == std::vector<double>{127.5 / 3, (63.75 + 127.5) / 3});
  CHECK(maps[1].kind == "error_signed");
  CHECK(maps[1].scale == 20);
  CHECK(maps[1].values == std::vector<double>{127.5 / 3, -(63.75 + 127.5) / 3});
}

}  // namespace moire::test
