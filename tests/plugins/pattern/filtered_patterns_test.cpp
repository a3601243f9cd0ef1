// Pixels under filters: against exact averages of small parts of pixels, each weighed by its own share of the filter.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "own_filters.h"
#include "pattern_frames.h"
#include "sampling/filters.h"
#include "weights/window.h"

namespace moire::test {

namespace {

constexpr ImageSize size{11, 8};

std::vector<std::unique_ptr<Filter>> all_filters() {
  std::vector<std::unique_ptr<Filter>> all;
  all.push_back(std::make_unique<BoxFilter>());
  for (const NamedSummary& named : filters()) {
    if (auto filter = make_filter(named.name, Settings(named.parameters), 0.25)) all.push_back(std::move(filter));
  }
  return all;
}

// Settings of an image that is `factor` times as large.
Changes enlarged(Changes changes, int factor) {
  for (auto& [name, value] : changes) {
    for (const char* length : {"view.x", "view.y", "sigma", "radius", "cell", "offset"}) {
      if (name == length) value = std::get<double>(value) * factor;
    }
    for (const char* frequency : {"frequency", "second_frequency"}) {
      if (name == frequency) value = std::get<double>(value) / factor;
    }
    if (name == "kind" && std::get<std::string>(value) == "zone_plate") {
      const double peak = 1.0 / factor;
      return enlarged(with({{"peak_frequency", peak}}, {changes.begin() + 1, changes.end()}), factor);
    }
  }
  return changes;
}

}  // namespace

TEST_CASE("under a box as a filter, every pattern is its exact average") {
  const BoxFilter box;
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const MadePattern made = made_pattern(example.changes, size);
    const ExactPixels exact(*made.frame), filtered(*made.frame, &box);
    double largest = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) largest = std::max(largest, std::abs(exact.red(x, y) - filtered.red(x, y)));
    }
    CHECK(largest < (is_smooth(example) ? 0x1p-23 : 1e-12));
  }
}

TEST_CASE("under every filter, a pixel is the sum of small squares of it and its neighbours, each with its weight") {
  // Parts of a pixel's side; so that the filter's margin is there too, the picture is larger by it all around.
  constexpr int parts = 16, margin = 4;
  const auto all = all_filters();
  std::size_t turn = 0;
  for (const Example& example : examples()) {
    const MadePattern made = made_pattern(example.changes, size);
    const MadePattern fine = made_pattern(enlarged(example.changes, parts),
                                          {(size.width + 2 * margin) * parts, (size.height + 2 * margin) * parts});
    if (made.frame->spectrum() && made.frame->spectrum()->sinusoids().empty())
      continue;  // the larger picture has another rate
    const ExactPixels small(*fine.frame);
    // Two filters a pattern, others in turn.
    for (int k = 0; k < 2; ++k) {
      const Filter& filter = *all[turn++ % all.size()];
      const pattern::Window window(filter);
      const ExactPixels filtered(*made.frame, &filter);
      CAPTURE(example.name, turn, filter.radius());
      for (const auto& [x, y] : {std::pair{5, 4}, {6, 3}, {0, 0}, {10, 7}}) {
        const auto from = [](int i) { return static_cast<double>(i) / parts - margin - 0.5; };
        const auto share = [&](int i) { return window.below(from(i + 1)) - window.below(from(i)); };
        // The least and the greatest that at() is in part i: it has its extremes in the parts' ends, or is flat there.
        const auto range = [&](int i) {
          constexpr double inside = 1e-9;
          return std::minmax({filter.at(from(i) + inside), filter.at(from(i + 1) - inside)});
        };
        double sum = 0, bound = 0x1p-23;  // floats
        for (int j = 0; j < (2 * margin + 1) * parts; ++j) {
          if (std::abs(from(j)) > filter.radius()) continue;
          for (int i = 0; i < (2 * margin + 1) * parts; ++i) {
            const double red = small.red(x * parts + i, y * parts + j);
            sum += share(i) * share(j) * red;
            // Within a part, weights differ from their mean by half their range at most; colours, which are 0 to 1, by
            // 2 red (1 - red) on average.
            const auto [u0, u1] = range(i);
            const auto [v0, v1] = range(j);
            const auto [low, high] = std::minmax({u0 * v0, u0 * v1, u1 * v0, u1 * v1});
            bound += (high - low) * red * (1 - red) / (parts * parts);
          }
        }
        CAPTURE(x, y);
        CHECK(std::abs(sum - filtered.red(x, y)) <= bound);
        CHECK(std::abs(filtered.weight(x, y) - 1) < 1e-11);
      }
    }
  }
}

TEST_CASE("a zone plate under a filter is the sum of its points, weighed") {
  const MadePattern made = made_pattern({}, size);
  const auto mitchell = make_mitchell(1.0 / 3, 1.0 / 3);
  const ExactPixels filtered(*made.frame, mitchell.get());
  for (const auto& [x, y] : {std::pair{5, 4}, {0, 0}, {10, 7}}) {
    // The midpoint rule: knots are on its grid, and its error is about h^2 / 24 of the second derivative, 40.
    constexpr int n = 64;
    double sum = 0;
    for (int j = 0; j < 4 * n; ++j) {
      for (int i = 0; i < 4 * n; ++i) {
        const double u = (i + 0.5) / n - 2, v = (j + 0.5) / n - 2;
        const SamplePoint point{x + 0.5 + u, y + 0.5 + v};
        Hit hit;
        Counters counters;
        made.frame->trace({&point, 1}, {&hit, 1}, counters);
        sum += mitchell->at(u) * mitchell->at(v) * hit.color.r / (n * n);
      }
    }
    CAPTURE(x, y);
    CHECK(std::abs(sum - filtered.red(x, y)) < 1e-3);
  }
}

TEST_CASE("under filters, weights of every pattern add up to 1 and elements are named as by points") {
  for (const auto& filter : all_filters()) {
    for (const Example& example : examples()) {
      if (example.name.find(" at ") != std::string::npos && example.name.find(" at 20") == std::string::npos) continue;
      CAPTURE(example.name, filter->radius());
      const MadePattern made = made_pattern(example.changes, {3, 3});
      const ExactPixels filtered(*made.frame, filter.get());
      CHECK(filtered.bound < 1e-8);
      for (int k = 0; k < 9; ++k) CHECK(std::abs(filtered.weight(k % 3, k / 3) - 1) < 1e-11);
      const SamplePoint middle{1.5, 1.5};
      Hit hit;
      Counters counters;
      made.frame->trace({&middle, 1}, {&hit, 1}, counters);
      const auto fragments = filtered.fragments(1, 1);
      CHECK(std::count_if(fragments.begin(), fragments.end(),
                          [&](const Fragment& f) { return f.element == hit.element; }) == 1);
    }
  }
}

}  // namespace moire::test
