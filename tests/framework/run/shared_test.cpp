// What scene entries share: never anything that would not have come out the same if it were made anew.
#include "run/shared.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include "message_of.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

using namespace parameter;

constexpr Parameter scene_parameters[] = {
    integer("size", 1, 0, 9, "", "fixed once made; 0: cannot be made"),
    real("x", 0, -9, 9, "", "").per_frame(),
    flag("fast", false, "").per_frame().exact_when("false"),
};

struct Counts {
  int made = 0, alive = 0, most_alive = 0, rendered = 0;
};
Counts counts;

// One colour everywhere: (size, x, fast).
class Plain final : public Frame {
 public:
  Plain(Color color, ImageSize size) : color_(color), size_(size) {}
  ImageSize size() const override { return size_; }
  void trace(std::span<const SamplePoint>, std::span<Hit> hits, Counters&) const override {
    std::fill(hits.begin(), hits.end(), Hit{1, color_});
  }

 private:
  Color color_;
  ImageSize size_;
};

class Counted final : public Scene {
 public:
  explicit Counted(std::int64_t size) : size_(size) {
    ++counts.made;
    counts.most_alive = std::max(counts.most_alive, ++counts.alive);
  }
  ~Counted() override { --counts.alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  std::unique_ptr<Frame> frame(const Settings& settings, ImageSize size) const override {
    return std::make_unique<Plain>(
        Color{static_cast<float>(size_), static_cast<float>(settings.real("x")), settings.flag("fast") ? 1.0F : 0.0F},
        size);
  }

 private:
  std::int64_t size_;
};

std::unique_ptr<Scene> make_scene(const Settings& settings) {
  if (settings.integer("size") == 0) throw Error("no scene of size 0");
  return std::make_unique<Counted>(settings.integer("size"));
}
constexpr ScenePlugin scene_plugin_a{.summary = "", .source = "", .parameters = scene_parameters, .make = make_scene};
constexpr ScenePlugin scene_plugin_b = scene_plugin_a;

Plugin scene_file(const char* name, const ScenePlugin& plugin) {
  return {.file = {}, .kind = Kind::scene, .name = name, .version = "1", .scene = &plugin};
}
const Plugin file_a = scene_file("a", scene_plugin_a), file_b = scene_file("b", scene_plugin_b);

// What the first trace says, in every pixel.
class Looks final : public Sampler {
 public:
  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    ++counts.rendered;
    return std::make_unique<Work>(request.frame);
  }

 private:
  class Work final : public Rendering {
   public:
    explicit Work(const Frame& frame) : frame_(frame) {}
    void render(PixelBlock& block) const override {
      const SamplePoint point{};
      Hit hit;
      frame_.trace({&point, 1}, {&hit, 1}, block.counters);
      for (std::size_t slot = 0; slot < block.slots(); ++slot) block.add(slot, hit.element, 1, hit.color);
    }

   private:
    const Frame& frame_;
  };
};
constexpr SamplerPlugin looks{.summary = "", .source = "", .make = [](const Settings&) -> std::unique_ptr<Sampler> {
                                return std::make_unique<Looks>();
                              }};
constexpr SamplerPlugin fails{.summary = "", .source = "", .make = [](const Settings&) -> std::unique_ptr<Sampler> {
                                throw Error("no reference today");
                              }};
const Plugin looks_file{.file = {}, .kind = Kind::sampler, .name = "looks", .version = "1", .sampler = &looks};
const Plugin fails_file{.file = {}, .kind = Kind::sampler, .name = "fails", .version = "1", .sampler = &fails};

SceneChoice scene(const Changes& changes, const Plugin& file = file_a) {
  return {"", &file, changed(scene_parameters, changes)};
}

const ReferenceStore no_store;
std::string last_origin;  // of the reference that was asked for last

// The colour of the reference of this scene.
Color reference(Shared& shared, const SceneChoice& choice, const char* name = "looks",
                const Plugin& file = looks_file) {
  shared.scene(choice);
  SceneChoice exact = choice;
  exact.settings = exact_settings(*choice.plugin->scene, choice.settings);
  ContentHashes hashes;
  const Reference& found =
      shared.reference({{{name, &file, Settings(), "nearest"}, {}, true}, exact, "", {2, 1}, 0, 1}, hashes, Workers(1));
  last_origin = found.origin;
  return found.picture.pixels.front();
}

}  // namespace

TEST_CASE("a scene is made again only where something differs that is fixed once it is made") {
  counts = {};
  Shared shared(no_store);
  const Scene* first = &shared.scene(scene({{"x", 1.0}}));
  CHECK(&shared.scene(scene({{"x", 2.0}})) == first);
  CHECK(&shared.scene(scene({{"x", 2.0}, {"fast", true}})) == first);
  CHECK(counts.made == 1);
  shared.scene(scene({{"size", std::int64_t{2}}}));
  CHECK(counts.made == 2);
  shared.scene(scene({{"size", std::int64_t{2}}}, file_b));
  CHECK(counts.made == 3);
  shared.scene(scene({{"size", std::int64_t{2}}}));
  CHECK(counts.made == 4);
  CHECK(counts.most_alive == 1);  // the heavy thing there is one of
}

TEST_CASE("a scene that cannot be made leaves room for the next, be it the one before") {
  counts = {};
  Shared shared(no_store);
  shared.scene(scene({}));
  CHECK(message_of([&] { shared.scene(scene({{"size", std::int64_t{0}}})); }) == "no scene of size 0");
  CHECK(counts.alive == 0);
  CHECK(reference(shared, scene({{"x", 3.0}})) == Color{1, 3, 0});
  CHECK(counts.made == 2);
}

TEST_CASE("a reference is rendered again only where its scene's exact settings or its recipe differ") {
  counts = {};
  Shared shared(no_store);
  CHECK(reference(shared, scene({{"x", 1.0}})) == Color{1, 1, 0});
  CHECK(last_origin == "computed now");
  CHECK(reference(shared, scene({{"x", 1.0}})) == Color{1, 1, 0});
  CHECK(last_origin == "the same as above");
  CHECK(reference(shared, scene({{"x", 1.0}, {"fast", true}})) == Color{1, 1, 0});
  CHECK(counts.rendered == 1);
  CHECK(reference(shared, scene({{"x", 2.0}})) == Color{1, 2, 0});
  CHECK(counts.rendered == 2);
  CHECK(reference(shared, scene({{"x", 2.0}}), "looks[n=2]") == Color{1, 2, 0});
  CHECK(counts.rendered == 3);
  CHECK(reference(shared, scene({{"x", 2.0}, {"size", std::int64_t{3}}}), "looks[n=2]") == Color{3, 2, 0});
  CHECK(counts.rendered == 4);
  // The same settings of another plugin are another scene.
  CHECK(reference(shared, scene({{"x", 2.0}, {"size", std::int64_t{3}}}, file_b), "looks[n=2]") == Color{3, 2, 0});
  CHECK(counts.rendered == 5);
}

TEST_CASE("a reference that could not be made is not taken for the one before") {
  counts = {};
  Shared shared(no_store);
  CHECK(reference(shared, scene({{"x", 1.0}})) == Color{1, 1, 0});
  CHECK(message_of([&] { reference(shared, scene({{"x", 1.0}}), "fails", fails_file); }) == "no reference today");
  CHECK(message_of([&] { reference(shared, scene({{"x", 1.0}}), "fails", fails_file); }) == "no reference today");
  CHECK(reference(shared, scene({{"x", 1.0}})) == Color{1, 1, 0});
  CHECK(counts.rendered == 2);
}

}  // namespace moire::test
