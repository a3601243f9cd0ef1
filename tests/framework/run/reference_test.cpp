#include "run/reference.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "message_of.h"
#include "run/empty_sampler.h"

namespace moire::test {

namespace {

using namespace parameter;

constexpr Parameter line_parameters[] = {integer("lines", 1, 1, 64, "lines", "how many"),
                                         choice("layout", "upright", "upright radial", "which")};

constexpr SamplerPlugin plain{.summary = "no reference", .source = ""};
constexpr SamplerPlugin many_points{
    .summary = "many points", .source = "", .reference = [](Questions, int, Settings&) { return Trust::many_points; }};
constexpr SamplerPlugin many_lines{.summary = "many lines",
                                   .source = "",
                                   .parameters = line_parameters,
                                   .reference = [](Questions answered, int effort, Settings& settings) {
                                     if ((answered & Questions::lines) == Questions::none) return Trust::none;
                                     settings.set("lines", std::int64_t{8} * effort);
                                     return Trust::many_lines;
                                   }};
constexpr SamplerPlugin exact{.summary = "exact", .source = "", .reference = [](Questions answered, int, Settings&) {
                                return (answered & Questions::polygons) == Questions::none ? Trust::none : Trust::exact;
                              }};

Plugin sampler(const char* name, const SamplerPlugin& plugin) {
  return {.file = {}, .kind = Kind::sampler, .name = name, .version = "1", .sampler = &plugin};
}

const Catalog& all() {
  static const Catalog catalog(
      {sampler("exact", exact), sampler("lines", many_lines), sampler("plain", plain), sampler("points", many_points)});
  return catalog;
}

// One colour everywhere, by settings that a scene has.
class OneColor final : public Frame {
 public:
  ImageSize size() const override { return {3, 2}; }
  void trace(std::span<const SamplePoint>, std::span<Hit> hits, Counters&) const override {
    std::fill(hits.begin(), hits.end(), Hit{1, {0.5F, 0.5F, 0.5F}});
  }
};

}  // namespace

TEST_CASE("the reference is the sampler that can be trusted most for what the scene answers") {
  using enum Questions;
  const ReferenceChoice of_points = best_reference(all(), points);
  CHECK(of_points.sampler.name == "points");
  CHECK_FALSE(of_points.is_exact);
  CHECK(best_reference(all(), points | lines).sampler.name == "lines[lines=16]");
  const ReferenceChoice of_polygons = best_reference(all(), points | lines | polygons);
  CHECK(of_polygons.sampler.name == "exact");
  CHECK(of_polygons.is_exact);
}

TEST_CASE("a reference is judged by one of half the effort") {
  const ReferenceChoice choice = best_reference(all(), Questions::points | Questions::lines);
  CHECK(choice.sampler.settings.integer("lines") == 16);
  CHECK(choice.sampler.lookup == "nearest");
  REQUIRE(choice.half);
  CHECK(choice.half->name == "lines[lines=8]");
  CHECK(choice.half->settings.integer("lines") == 8);
  CHECK(choice.half->settings.text("layout") == "upright");
}

TEST_CASE("a scene for which no sampler is a reference is told so") {
  CHECK(message_of([] { best_reference(Catalog({sampler("plain", plain)}), Questions::points); }) ==
        "reference: no sampler can serve as reference for this scene; name one in the experiment");
  CHECK(message_of([] { best_reference(Catalog({sampler("lines", many_lines)}), Questions::points); }) ==
        "reference: no sampler can serve as reference for this scene; name one in the experiment");
}

TEST_CASE("exact settings override only what the scene's table says, in its type") {
  static constexpr Parameter table[] = {flag("fast", true, "").exact_when("false"),
                                        integer("steps", 4, 1, 64, "", "").exact_when("32"),
                                        real("slack", 0.5, 0, 1, "", "").exact_when("0.25"),
                                        choice("walk", "major", "grid major", "").exact_when("grid"),
                                        flag("foggy", true, ""),
                                        real("far", 9, 0, 10, "", "")};
  const ScenePlugin scene{.summary = "", .source = "", .parameters = table};
  Settings given(table);
  given.set("far", 3.0);
  const Settings found = exact_settings(scene, given);
  CHECK_FALSE(found.flag("fast"));
  CHECK(found.integer("steps") == 32);
  CHECK(found.real("slack") == 0.25);
  CHECK(found.text("walk") == "grid");
  CHECK(found.flag("foggy"));
  CHECK(found.real("far") == 3);
}

TEST_CASE("a reference says how it was made, and how far it is from one of half the effort") {
  static constexpr SamplerPlugin middle{
      .summary = "", .source = "", .make = [](const Settings&) { return make_empty_sampler(); }};
  const Plugin plugin = sampler("middle", middle);
  const SamplerChoice full{"middle[n=2]", &plugin, Settings(), "nearest"};
  const SamplerChoice half{"middle", &plugin, Settings(), "nearest"};
  const OneColor frame;

  const Reference judged = make_reference({full, half, false}, "walk=grid", frame, 0, 1, Workers(1));
  CHECK(judged.recipe == "middle[n=2]; walk=grid");
  CHECK(judged.error == 0);
  CHECK(judged.how == "rmse of middle against it: the reference, with twice as many, is nearer to the truth");
  CHECK(judged.picture.pixels == std::vector<Color>(6));

  const Reference named = make_reference({full, {}, false}, "", frame, 0, 1, Workers(1));
  CHECK(named.recipe == "middle[n=2]");
  CHECK(std::isnan(named.error));
  CHECK(named.how == "unknown: the experiment names this reference");

  const Reference sure = make_reference({full, half, true}, "", frame, 0, 1, Workers(1));
  CHECK(sure.error == 0);
  CHECK(sure.how == "exact: no sampling error");
}

TEST_CASE("exact fragments are of the frame that is asked for: a reference may draw random numbers") {
  // Deposits one element, named after the frame's number and the seed.
  class Numbered final : public Sampler {
    class Work final : public Rendering {
     public:
      explicit Work(Element element) : element_(element) {}
      void render(PixelBlock& block) const override {
        for (std::size_t slot = 0; slot < block.slots(); ++slot) block.add(slot, element_, 1, {});
      }

     private:
      Element element_;
    };

   public:
    std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
      return std::make_unique<Work>(static_cast<Element>(request.frame_number) * 100 + request.seed);
    }
  };
  static constexpr SamplerPlugin numbered{
      .summary = "", .source = "", .make = [](const Settings&) -> std::unique_ptr<Sampler> {
        return std::make_unique<Numbered>();
      }};
  const Plugin plugin = sampler("numbered", numbered);
  const ReferenceChoice choice{{"numbered", &plugin, Settings(), "nearest"}, {}, false};
  const auto blocks = exact_fragments(Against::pixel, choice, OneColor(), 7, 5, Workers(1));
  REQUIRE(blocks.size() == 1);
  REQUIRE(blocks[0].pixel(0).size() == 1);
  CHECK(blocks[0].pixel(0)[0].element == 705);
}

}  // namespace moire::test
