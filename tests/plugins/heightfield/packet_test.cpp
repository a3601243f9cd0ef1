// Lines followed side by side, held to the same lines followed one by one, whose own tests hold them to single rays:
// the same bits, whatever the view, the company and the machine's vectors.
#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numeric>

#include <moire/random.h>

#include <hwy/targets.h>

#include "frame.h"
#include "packet.h"
#include "plugins/heightfield/views.h"
#include "sampling/lookups.h"
#include "view_settings.h"

namespace moire::test {
namespace {

struct Ground {
  heightfield::Voxels voxels;
  Texture texture;

  explicit Ground(const Map& map)
      : voxels(heightfield::Terrain{map.columns, map.rows, map.heights, map.colors}), texture(voxels.texture()) {}

  heightfield::Look look(const View& view, const Changes& changes) const {
    Settings settings = changed(scene_plugin("heightfield").parameters, settings_of(view));
    settings.set("walk", std::string("major"));
    for (const auto& [name, value] : changes) settings.set(name, value);
    const heightfield::Camera camera = heightfield::camera_of(settings, view.size);
    return {view.size, heightfield::view_of(settings, voxels, camera), camera, heightfield::manner_of(settings)};
  }
};

constexpr Color sky{0.25F, 0.5F, 0.75F};

// Two upright lines a pixel, and what a scene deposits for all of them.
struct Batch {
  std::vector<double> cuts;
  std::vector<ImageLine> lines;

  explicit Batch(ImageSize size) : cuts(static_cast<std::size_t>(size.height) + 1) {
    std::iota(cuts.begin(), cuts.end(), 0.0);
    for (int k = 0; k < 2 * size.width; ++k) {
      const double x = (k + 0.5) / 2;
      lines.push_back({{x, static_cast<double>(size.height)}, {x, 0}, cuts});
    }
  }
  std::size_t rows() const { return cuts.size() - 1; }
};

struct Deposits {
  std::vector<double> weights;
  std::vector<Color> colors;
  Counters counters;
};

// `together`: so many lines a call; fewer than three are followed one by one.
Deposits deposits(const Frame& frame, const Batch& batch, const Lookup* lookup, std::size_t together) {
  Deposits all;
  for (std::size_t first = 0; first < batch.lines.size(); first += together) {
    const auto some = std::span(batch.lines).subspan(first, std::min(together, batch.lines.size() - first));
    Tally pieces(some.size() * batch.rows(), false);
    frame.lines()->along(some, lookup, pieces);
    for (std::size_t slot = 0; slot < pieces.slots(); ++slot) {
      all.weights.push_back(pieces.weight(slot));
      all.colors.push_back(pieces.color(slot));
    }
    all.counters += pieces.counters;
  }
  return all;
}

std::string difference(const Deposits& one, const Deposits& other) {
  const auto bits = [](const auto& value) { return std::bit_cast<std::array<std::uint32_t, sizeof value / 4>>(value); };
  for (std::size_t k = 0; k < one.weights.size(); ++k) {
    if (bits(one.weights[k]) != bits(other.weights[k])) {
      return fmt::format("stretch {}: weight {:.17g}, {:.17g}", k, one.weights[k], other.weights[k]);
    }
    if (bits(one.colors[k]) != bits(other.colors[k])) {
      return fmt::format("stretch {}: red {:.9g}, {:.9g}", k, one.colors[k].r, other.colors[k].r);
    }
  }
  const Counters &a = one.counters, &b = other.counters;
  if (a == b) return {};
  return fmt::format("queries {}, {}; hits {}, {}; steps {}, {}", a.queries, b.queries, a.hits, b.hits, a.steps,
                     b.steps);
}

// How many of the lines packets do follow.
int followed(const heightfield::Look& look, heightfield::Interpolation interpolation, const Batch& batch) {
  if (!heightfield::packets_fit(look)) return 0;
  std::vector<std::size_t> first_slots;
  for (std::size_t k = 0; k < batch.lines.size(); ++k) first_slots.push_back(k * batch.rows());
  Tally pieces(batch.lines.size() * batch.rows(), false);
  std::vector<bool> done(batch.lines.size());
  heightfield::follow_in_packets(look, sky, interpolation, batch.lines, first_slots, pieces, done);
  return static_cast<int>(std::count(done.begin(), done.end(), true));
}

// Views from above all summits, in every direction.
std::vector<View> random_views(const Map& map, int count) {
  const double highest = *std::max_element(map.heights.begin(), map.heights.end());
  std::vector<View> views;
  for (int k = 0; k < count; ++k) {
    const auto number = [&](int dimension) { return random({.x = k}, 0, dimension); };
    View view;
    view.caption = fmt::format("random view {}", k);
    view.x = 1000 * number(0) - 500;
    view.y = 1000 * number(1) - 500;
    view.z = highest + 1e-3 + 30 * number(2) * number(3);
    view.yaw = 360 * number(4);
    view.pitch = 40 - 120 * number(5);
    view.fov = 5 + 90 * number(6) * number(7);
    view.far = 300 * number(8) * number(9);
    view.spacing_x = k % 3 == 0 ? 0.7 : 1;
    view.size = {1 + static_cast<int>(30 * number(10)), 1 + static_cast<int>(30 * number(11))};
    views.push_back(view);
  }
  return views;
}

struct Tested {
  int followed = 0, lines = 0;
};

// Compares all views of a map, over both lookups, with and without levels.
Tested compare(const Map& map, const std::vector<View>& views) {
  const Ground ground(map);
  const auto across = make_linear_across();
  Tested tested;
  for (const View& view : views) {
    const Batch batch(view.size);
    for (const char* levels : {"none", "floor"}) {
      for (const Lookup* lookup : {static_cast<const Lookup*>(nullptr), static_cast<const Lookup*>(across.get())}) {
        CAPTURE(view.caption, view.yaw, view.pitch, view.fov, levels, lookup != nullptr);
        const heightfield::Look look = ground.look(view, {{"levels", std::string(levels)}});
        const heightfield::HeightfieldFrame frame(look, sky, ground.texture, false);
        const Deposits one_by_one = deposits(frame, batch, lookup, 1);
        CHECK(difference(deposits(frame, batch, lookup, batch.lines.size()), one_by_one) == "");
        CHECK(difference(deposits(frame, batch, lookup, 7), one_by_one) == "");
        const auto interpolation =
            lookup ? heightfield::Interpolation::linear_across : heightfield::Interpolation::nearest;
        tested.followed += followed(look, interpolation, batch);
        tested.lines += static_cast<int>(batch.lines.size());
      }
    }
  }
  return tested;
}

// Only these vectors are used for as long as it lives.
class OnlyVectors {
 public:
  explicit OnlyVectors(std::int64_t target) { use(target); }
  OnlyVectors(const OnlyVectors&) = delete;
  OnlyVectors& operator=(const OnlyVectors&) = delete;
  ~OnlyVectors() { use(0); }

 private:
  static void use(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace

TEST_CASE("lines followed side by side get the bits of lines followed one by one, in all directions") {
  const Map map = rough_map(16, 16, 8);
  const Tested tested = compare(map, random_views(map, 300));
  // Others see across an octant's border or past the nadir.
  CHECK(tested.followed > tested.lines / 2);
}

TEST_CASE("lines followed side by side get the bits of lines followed one by one, in awkward views") {
  const Map map = usual_map();
  const Tested tested = compare(map, all_views(map));
  CHECK(tested.followed > 10'000);
}

TEST_CASE("lines followed side by side get the bits of lines followed one by one, on flat and on narrow maps") {
  for (const Map& map :
       {flat_map(8, 8), flat_map(1, 1), rough_map(1, 24, 5), rough_map(24, 1, 5), rough_map(64, 2, 3)}) {
    CAPTURE(map.columns, map.rows);
    const Tested tested = compare(map, random_views(map, 40));
    CHECK(tested.followed > tested.lines / 3);
  }
}

TEST_CASE("lines followed side by side fill every pixel") {
  const Map map = rough_map(32, 32, 6);
  const Ground ground(map);
  for (const View& view : random_views(map, 50)) {
    CAPTURE(view.caption);
    const heightfield::HeightfieldFrame frame(ground.look(view, {}), sky, ground.texture, false);
    const Batch batch(view.size);
    const Deposits all = deposits(frame, batch, nullptr, batch.lines.size());
    // Each run's end and each sum of runs is rounded once; a run ends within the image, a sum within the pixel.
    const double runs = static_cast<double>(all.counters.hits) + 1;
    const double bound = runs * 0x1p-53 * (view.size.height + 1);
    for (const double weight : all.weights) CHECK(std::abs(weight - 1) <= bound);
  }
}

TEST_CASE("lines followed side by side get the same bits from all vectors of this machine") {
  const Map map = rough_map(64, 64, 12);
  const Ground ground(map);
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  CHECK(targets.size() >= 2);
  std::vector<std::size_t> lanes;
  const auto across = make_linear_across();
  for (const View& view : random_views(map, 30)) {
    CAPTURE(view.caption);
    const heightfield::HeightfieldFrame frame(ground.look(view, {{"levels", std::string("floor")}}), sky,
                                              ground.texture, false);
    const Batch batch(view.size);
    const Deposits best = deposits(frame, batch, across.get(), batch.lines.size());
    for (const std::int64_t target : targets) {
      const OnlyVectors only(target);
      CAPTURE(hwy::TargetName(target));
      lanes.push_back(heightfield::lanes_of_packets());
      CHECK(difference(deposits(frame, batch, across.get(), batch.lines.size()), best) == "");
    }
  }
  CHECK(*std::min_element(lanes.begin(), lanes.end()) < *std::max_element(lanes.begin(), lanes.end()));
}

}  // namespace moire::test
