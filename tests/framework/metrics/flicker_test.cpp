// Flicker against the same numbers counted from stored images, with sRGB codes found the other way round.
#include "metrics/flicker.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

#include <moire/random.h>

#include "metrics/registry.h"

namespace moire::test {

namespace {

using Values = std::map<std::string, double>;

// Frames of one size; pixel (x, y) of a frame at y * width + x.
struct Movie {
  ImageSize size;
  std::vector<std::vector<Color>> frames;

  Color at(std::size_t frame, int x, int y) const {
    return frames[frame][static_cast<std::size_t>(y * size.width + x)];
  }
};

// Colours from -0.2 to 1.2, many of them near black and near each other in time, some that stay.
Movie random_movie(ImageSize size, std::size_t frames, std::uint64_t seed) {
  Movie movie{size, {}};
  std::uint32_t drawn = 0;
  const auto next = [&] { return random({.seed = seed}, drawn++, 0); };
  for (std::size_t f = 0; f < frames; ++f) {
    auto& frame = movie.frames.emplace_back();
    for (int k = 0; k < size.width * size.height; ++k) {
      const double reach = next() < 0.5 ? 0.01 : 1.4;
      const auto channel = [&] { return static_cast<float>(reach * next() - (reach > 1 ? 0.2 : 0)); };
      const float r = channel(), g = channel(), b = channel();
      frame.push_back({r, g, b});
      const bool stays = f > 0 && next() < 0.2;
      if (stays) frame.back() = movie.frames[f - 1][static_cast<std::size_t>(k)];
    }
  }
  return movie;
}

PixelBlock block(const Movie& movie, std::size_t frame, const Columns& columns) {
  PixelBlock result({columns.x0, 0, columns.width, movie.size.height}, false);
  for (int x = columns.x0; x < columns.x0 + columns.width; ++x) {
    for (int y = 0; y < movie.size.height; ++y) result.add(result.slot(x, y), 1, 1, movie.at(frame, x, y));
  }
  return result;
}

constexpr const char* unrounded = "flicker.excess_unrounded";

Values all_flicker(const Movie& own, const Movie& reference, const std::string& of, std::int64_t column = -1) {
  Settings settings(flicker_description.parameters);
  settings.set("of", of);
  settings.set("column", column);
  const auto metric = make_flicker(settings, own.size);
  const Needs needs = metric->needs();
  for (std::size_t f = 0; f < own.frames.size(); ++f) {
    const PixelBlock seen = block(own, f, needs.columns), truth = block(reference, f, needs.columns);
    metric->see({static_cast<int>(f), seen, &truth, nullptr});
  }
  Values values;
  for (const Measurement& m : metric->finish()) values[std::string(m.quantity)] = m.value;
  return values;
}

// What is counted in whole codes.
Values flicker(const Movie& own, const Movie& reference, const std::string& of, std::int64_t column = -1) {
  Values values = all_flicker(own, reference, of, column);
  values.erase(unrounded);
  return values;
}

// The 8-bit code of a light: how many of the 255 borders between codes, turned into light, lie below it.
int code_of(float light) {
  int code = 0;
  while (code < 255 && light > srgb_to_linear((code + 0.5) / 255)) ++code;
  return code;
}

std::array<int, 3> codes_of(Color c) { return {code_of(c.r), code_of(c.g), code_of(c.b)}; }

// By the definition: every pixel of columns x0 .. x1 - 1, every pair of consecutive frames.
Values brute_force(const Movie& own, const Movie& reference, int x0, int x1) {
  std::vector<int> changes, excesses;
  for (std::size_t f = 1; f < own.frames.size(); ++f) {
    for (int y = 0; y < own.size.height; ++y) {
      for (int x = x0; x < x1; ++x) {
        const auto a = codes_of(own.at(f - 1, x, y)), b = codes_of(own.at(f, x, y));
        const auto r = codes_of(reference.at(f - 1, x, y)), s = codes_of(reference.at(f, x, y));
        int change = 0, excess = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          change = std::max(change, std::abs(b[c] - a[c]));
          excess = std::max(excess, std::abs((b[c] - a[c]) - (s[c] - r[c])));
        }
        changes.push_back(change);
        excesses.push_back(excess);
      }
    }
  }
  const auto n = static_cast<double>(changes.size());
  Values values;
  for (int k = 0; k < 6; ++k) {
    values["flicker.changed_by_" + std::to_string(k)] =
        static_cast<double>(std::count(changes.begin(), changes.end(), k)) / n;
  }
  values["flicker.changed_by_6_up"] =
      static_cast<double>(std::count_if(changes.begin(), changes.end(), [](int c) { return c >= 6; })) / n;
  double change_sum = 0, excess_sum = 0;
  for (int c : changes) change_sum += c;
  for (int e : excesses) excess_sum += e;
  values["flicker.mean"] = change_sum / n;
  values["flicker.excess"] = excess_sum / n;
  return values;
}

// From lights, by the definition.
double unrounded_excess(const Movie& own, const Movie& reference) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t f = 1; f < own.frames.size(); ++f) {
    for (std::size_t k = 0; k < own.frames[f].size(); ++k, ++count) {
      const auto change = [&](const Movie& movie, float Color::*channel) {
        const auto code = [&](std::size_t frame) {
          const double light = std::clamp<double>(movie.frames[frame][k].*channel, 0, 1);
          return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
        };
        return code(f) - code(f - 1);
      };
      double largest = 0;
      for (float Color::*channel : {&Color::r, &Color::g, &Color::b})
        largest = std::max(largest, std::abs(change(own, channel) - change(reference, channel)));
      sum += largest;
    }
  }
  return sum / static_cast<double>(count);
}

double sum_of_shares(const Values& values) {
  double sum = values.at("flicker.changed_by_6_up");
  for (int k = 0; k < 6; ++k) sum += values.at("flicker.changed_by_" + std::to_string(k));
  return sum;
}

}  // namespace

TEST_CASE("flicker is what counting stored images gives, of a column and of the image") {
  const Movie own = random_movie({5, 40}, 9, 1), reference = random_movie({5, 40}, 9, 2);
  for (int column = 0; column < 5; ++column) {
    CAPTURE(column);
    CHECK(flicker(own, reference, "column", column) == brute_force(own, reference, column, column + 1));
  }
  CHECK(flicker(own, reference, "image") == brute_force(own, reference, 0, 5));
  // Sums of at most 255 a pixel in another order.
  CHECK(all_flicker(own, reference, "image").at(unrounded) ==
        Catch::Approx(unrounded_excess(own, reference)).epsilon(1e-12));
  // Each of the shares is there to be counted wrongly.
  for (const auto& [name, value] : brute_force(own, reference, 0, 5)) {
    CAPTURE(name);
    CHECK(value > 0);
  }
}

TEST_CASE("every row of the description is measured, in its order") {
  const Movie movie = random_movie({1, 2}, 2, 3);
  const auto metric = make_flicker(Settings(flicker_description.parameters), movie.size);
  for (std::size_t f = 0; f < 2; ++f) {
    const PixelBlock seen = block(movie, f, {0, 1});
    metric->see({static_cast<int>(f), seen, &seen, nullptr});
  }
  const auto found = metric->finish();
  REQUIRE(found.size() == flicker_description.quantities.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    CHECK(found[k].quantity == flicker_description.quantities[k].name);
  }
}

TEST_CASE("the shares of all changes sum to 1") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Movie own = random_movie({7, 3}, 4, seed);
    CHECK(sum_of_shares(flicker(own, own, "image")) == Catch::Approx(1).epsilon(1e-15));  // seven roundings
  }
}

TEST_CASE("the reference itself, and what differs from it by a constant code, has no excess") {
  const Movie reference = random_movie({4, 10}, 6, 4);
  const Values found = flicker(reference, reference, "image");
  CHECK(found.at("flicker.excess") == 0);
  CHECK(found.at("flicker.mean") > 0);

  // Two pixels that always lie 10 codes apart, from code to code up and down.
  const auto light = [](int code) { return static_cast<float>(srgb_to_linear(code / 255.0)); };
  Movie low{{1, 1}, {}}, high{{1, 1}, {}};
  for (const int code : {100, 103, 90, 90, 240}) {
    low.frames.push_back({{light(code), 0, 1}});
    high.frames.push_back({{light(code + 10), 1, 0}});
  }
  const Values shifted = flicker(high, low, "image");
  CHECK(shifted.at("flicker.excess") == 0);
  CHECK(shifted.at("flicker.mean") == (3 + 13 + 0 + 150) / 4.0);
}

TEST_CASE("excess has a sign: against the reference's motion counts twice") {
  const auto light = [](int code) { return static_cast<float>(srgb_to_linear(code / 255.0)); };
  const Movie up{{1, 1}, {{{light(10), 0, 0}}, {{light(17), 0, 0}}}};
  const Movie down{{1, 1}, {{{light(17), 0, 0}}, {{light(10), 0, 0}}}};
  CHECK(flicker(up, down, "image").at("flicker.excess") == 14);
  CHECK(flicker(up, down, "image").at("flicker.mean") == 7);
}

TEST_CASE("a still movie has no change; light beyond black and white is cut off as a screen does") {
  const Movie still{{1, 2}, {{{0.5F, 0, 1}, {1, 1, 1}}, {{0.5F, -3, 7}, {2, 1.5F, 9}}}};
  const Values found = flicker(still, still, "image");
  CHECK(found.at("flicker.changed_by_0") == 1);
  CHECK(found.at("flicker.mean") == 0);

  const Movie flash{{1, 1}, {{{-1, -1, -1}}, {{2, 2, 2}}}};
  CHECK(flicker(flash, flash, "image").at("flicker.mean") == 255);
  const float infinity = std::numeric_limits<float>::infinity();
  const Movie bolt{{1, 1}, {{{-infinity, 0, 0}}, {{infinity, 0, 0}}}};
  CHECK(flicker(bolt, bolt, "image").at("flicker.mean") == 255);
}

TEST_CASE("what is not a number makes no number of any row") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Movie own = random_movie({2, 2}, 4, 5);
  const Movie whole = own;
  own.frames[3][1].g = nan;
  for (const auto& [name, value] : flicker(own, whole, "image")) CHECK(std::isnan(value));
  for (const auto& [name, value] : flicker(whole, own, "image")) CHECK(std::isnan(value));
  // Where nobody looks it does no harm.
  CHECK(flicker(own, whole, "column", 0) == brute_force(whole, whole, 0, 1));
}

TEST_CASE("flicker of the image is the mean of that of its columns") {
  const Movie own = random_movie({6, 8}, 5, 6), reference = random_movie({6, 8}, 5, 7);
  Values sum;
  for (int column = 0; column < 6; ++column) {
    for (const auto& [name, value] : flicker(own, reference, "column", column)) sum[name] += value;
  }
  for (const auto& [name, value] : flicker(own, reference, "image")) {
    CAPTURE(name);
    CHECK(value == Catch::Approx(sum[name] / 6).epsilon(1e-14));  // roundings of six shares and their sum
  }
}

TEST_CASE("column -1 is the middle one") {
  for (const int width : {1, 2, 5, 6}) {
    const Movie own = random_movie({width, 8}, 5, 8), reference = random_movie({width, 8}, 5, 9);
    CHECK(flicker(own, reference, "column", -1) == flicker(own, reference, "column", width / 2));
  }
}

TEST_CASE("flicker asks for its columns of every frame, the reference's too") {
  Settings settings(flicker_description.parameters);
  settings.set("column", std::int64_t{3});
  const Needs of_column = make_flicker(settings, {10, 4})->needs();
  CHECK(of_column.columns == Columns{3, 1});
  CHECK(of_column.every_frame);
  CHECK(of_column.reference);
  CHECK(of_column.of_reference);
  CHECK_FALSE(of_column.fragments);
  CHECK_FALSE(of_column.exact);
  settings.set("of", std::string("image"));
  CHECK(make_flicker(settings, {10, 4})->needs().columns == Columns{0, 10});
}

TEST_CASE("flicker needs two frames, and its column lies in the image") {
  const auto problem = [](const char* of, std::int64_t column, int frames) {
    Settings settings(flicker_description.parameters);
    settings.set("of", std::string(of));
    settings.set("column", column);
    return flicker_description.problem(settings, {{10, 4}, frames});
  };
  CHECK(problem("column", 9, 2).empty());
  CHECK(problem("column", -1, 2).empty());
  CHECK(problem("column", 10, 2) == "watches column 10; the image has columns 0 to 9");
  CHECK(problem("image", 10, 2).empty());
  CHECK(problem("image", -1, 1) == "compares consecutive frames; give \"frames\" a \"count\" of 2 or more");
}

}  // namespace moire::test
