#include "run/reference.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <random>

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
constexpr SamplerPlugin exact{.summary = "exact",
                              .source = "",
                              .asks = [](const Settings&) { return Questions::polygons; },
                              .reference =
                                  [](Questions answered, int, Settings&) {
                                    return (answered & Questions::polygons) == Questions::none ? Trust::none
                                                                                               : Trust::exact;
                                  }};

Plugin sampler(const char* name, const SamplerPlugin& plugin) {
  return {.file = {}, .kind = Kind::sampler, .name = name, .version = "1", .sampler = &plugin};
}

Plugin scene_file(const char* name, const ScenePlugin& plugin) {
  return {.file = {}, .kind = Kind::scene, .name = name, .version = "1", .scene = &plugin};
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

TEST_CASE("colours are judged by what the exact scene allows, fragments by what the contenders' own does") {
  // As a terrain with a hierarchy: polygons only where it is exact.
  static constexpr Parameter table[] = {flag("levels", true, "").exact_when("false")};
  static constexpr ScenePlugin terrain{
      .summary = "", .source = "", .parameters = table, .answers = [](const Settings& settings) {
        using enum Questions;
        return settings.flag("levels") ? points | lines : points | lines | polygons;
      }};
  const Plugin file = scene_file("terrain", terrain);
  SceneChoice scene{"", &file, Settings(table)};
  const References own = choose_references({}, all(), scene);
  CHECK(own.colors.sampler.name == "exact");
  CHECK(own.colors.is_exact);
  CHECK(own.fragments.sampler.name == "lines[lines=16]");
  CHECK_FALSE(own.fragments.is_exact);

  const Plugin* exact_file = all().find(Kind::sampler, "exact");
  const SamplerChoice named{"truth", exact_file, Settings(), "nearest"};
  CHECK(choose_references(named, all(), scene).colors.sampler.name == "truth");
  CHECK(choose_references(named, all(), scene).fragments.sampler.name == "lines[lines=16]");

  scene.settings.set("levels", false);
  CHECK(choose_references({}, all(), scene).fragments.sampler.name == "exact");
  CHECK(choose_references(named, all(), scene).fragments.sampler.name == "truth");
}

TEST_CASE("a named reference is trusted as far as its sampler offers itself with these very settings") {
  const Plugin* file = all().find(Kind::sampler, "lines");
  const Questions answered = Questions::points | Questions::lines;
  SamplerChoice named{"my lines", file, Settings(line_parameters), "nearest"};
  CHECK_FALSE(named_reference(named, answered).half);
  named.settings.set("lines", std::int64_t{16});
  const ReferenceChoice offered = named_reference(named, answered);
  CHECK(offered.sampler.name == "my lines");
  REQUIRE(offered.half);
  CHECK(offered.half->name == "lines[lines=8]");
  CHECK_FALSE(named_reference(named, Questions::points).half);
  named.lookup = "bilinear";
  CHECK_FALSE(named_reference(named, answered).half);

  const SamplerChoice sure{"truth", all().find(Kind::sampler, "exact"), Settings(), "nearest"};
  CHECK(named_reference(sure, Questions::polygons).is_exact);
  CHECK_FALSE(named_reference(sure, Questions::points).is_exact);
  const SamplerChoice plain_one{"plain", all().find(Kind::sampler, "plain"), Settings(), "nearest"};
  CHECK_FALSE(named_reference(plain_one, answered).is_exact);
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
  CHECK(exact_note(scene, given) == "fast=false, steps=32, slack=0.25, walk=grid");
  given.set("steps", std::int64_t{32});
  CHECK(exact_note(scene, given) == "fast=false, slack=0.25, walk=grid");
  CHECK(exact_note(scene, found) == "");
}

TEST_CASE("a reference says how it was made, and how far it is from one of half the effort") {
  static constexpr SamplerPlugin middle{
      .summary = "", .source = "", .make = [](const Settings&) { return make_empty_sampler(); }};
  const Plugin plugin = sampler("middle", middle);
  const SamplerChoice full{"middle[n=2]", &plugin, Settings(), "nearest"};
  const SamplerChoice half{"middle", &plugin, Settings(), "nearest"};
  const OneColor frame;

  static constexpr ScenePlugin plain_scene{.summary = "", .source = ""};
  const Plugin file = scene_file("plain", plain_scene);
  const auto made = [&](const ReferenceChoice& choice, const std::string& changes) {
    return make_reference({choice, {"", &file, Settings()}, changes, frame.size(), 0, 1}, frame, Workers(1));
  };

  const ReferenceChoice by_half{full, half, false}, by_name{full, {}, false}, by_proof{full, half, true};
  const Reference judged = made(by_half, "walk=grid");
  CHECK(judged.recipe == "middle[n=2]; walk=grid");
  CHECK(judged.error == 0);
  CHECK(judged.how == "rmse of middle against it: the reference, with twice as many, is nearer to the truth");
  CHECK(judged.picture.pixels == std::vector<Color>(6));
  CHECK(trust_in(judged, by_half) == "its own error is about 0 levels, the rmse of middle against it");

  const Reference named = made(by_name, "");
  CHECK(named.recipe == "middle[n=2]");
  CHECK(std::isnan(named.error));
  CHECK(named.how == "unknown: the experiment names this reference");
  CHECK(trust_in(named, by_name) == "named by the experiment, its own error is unknown");

  const Reference sure = made(by_proof, "");
  CHECK(sure.error == 255.0 / 16777216);
  CHECK(sure.how ==
        "exact: no sampling error; pixels are kept as floats, and two that are rounded differ by 2^-24 at most");
  CHECK(trust_in(sure, by_proof) == "exact, no sampling error");
}

TEST_CASE("two pictures that are exact but for rounding differ by no more than the exact reference's own error") {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double largest = 0;
  for (int k = 0; k < 1'000'000; ++k) {
    // Of all sizes below 1; what both round is the same to 1e-9, hundreds of times what is asked of integrators.
    const double truth = uniform(0, 1) * std::exp2(-static_cast<int>(random() % 30));
    const Picture one{{1, 1}, {{static_cast<float>(std::clamp(truth + uniform(-0.5e-9, 0.5e-9), 0.0, 1.0)), 0, 0}}};
    const Picture other{{1, 1}, {{static_cast<float>(truth), 0, 0}}};
    largest = std::max(largest, std::abs(differences(one, other, Space::linear)[0]));
  }
  CHECK(largest == exact_error);  // reached where a value lies between two floats, never passed
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
