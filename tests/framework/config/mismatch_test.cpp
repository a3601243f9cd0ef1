#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

TEST_CASE("pairs that fit have nothing to say") {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(experiment_with({R"("samplers": ["point", "area", "bilinear"])"}));
  for (const auto& sampler : experiment.samplers) CHECK(mismatch(experiment.scenes[0], sampler, vocabulary()) == "");
}

TEST_CASE("a sampler that asks what a scene cannot answer is refused with the scenes that would do") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": [{"type": "textured_plane", "label": "plane"}, "heightfield"])",
                              R"("samplers": ["point", {"type": "area", "layout": "radial"}])",
                              R"("reference": {"type": "area", "method": "exact"})"}) ==
        "edges/experiment.json:5: samplers[1]: \"area[layout=radial]\" asks for lines through a common point, which "
        "scene \"plane\" (textured_plane) does not have; scenes that do: heightfield\n"
        "edges/experiment.json:6: reference: \"area[method=exact]\" asks for polygons, which scene \"plane\" "
        "(textured_plane) does not have; scenes that do: cartoon\n"
        "edges/experiment.json:6: reference: \"area[method=exact]\" asks for polygons, which scene \"heightfield\" "
        "(heightfield) does not have; scenes that do: cartoon");
}

TEST_CASE("a lookup asks too, unless it is the first") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with(
          {R"("scenes": ["cartoon"])",
           R"("samplers": ["bilinear", {"type": "area", "method": "exact", "lookup": "bilinear"}])"}) ==
      "edges/experiment.json:5: samplers[0]: \"bilinear\" asks for places on a texture (for its lookup, bilinear), "
      "which scene \"cartoon\" (cartoon) does not have; scenes that do: heightfield, textured_plane\n"
      "edges/experiment.json:5: samplers[1]: \"area[method=exact,lookup=bilinear]\" asks for places on a texture (for "
      "its lookup, bilinear), which scene \"cartoon\" (cartoon) does not have; no known scene does");
}

TEST_CASE("a metric asks too, of every scene") {
  const ExperimentFolder folder;
  const std::string scenes = R"("scenes": [{"type": "textured_plane", "label": "plane"}, "heightfield"])";
  CHECK(folder.problems_with({scenes, R"("metrics": ["error", {"type": "coverage", "against": "column"}])"}) ==
        "edges/experiment.json:6: metrics[1]: \"coverage\" asks for lines, which scene \"plane\" (textured_plane) does "
        "not "
        "have; scenes that do: cartoon, heightfield");
  CHECK(folder.problems_with({scenes, R"("metrics": ["error", {"type": "coverage", "against": "pixel"}])"}) ==
        "(no error)");
}

// A terrain that has polygons only where it is exact.
const Vocabulary& with_exact_terrain() {
  using namespace parameter;
  static constexpr Parameter parameters[] = {choice("levels", "some", "some none", "").exact_when("none")};
  static constexpr ScenePlugin terrain{
      .summary = "", .source = "", .parameters = parameters, .answers = [](const Settings& settings) {
        return settings.text("levels") == "none" ? Questions::points | Questions::polygons : Questions::points;
      }};
  static constexpr SamplerPlugin exact{
      .summary = "", .source = "", .asks = [](const Settings&) { return Questions::polygons; }};
  static constexpr SamplerPlugin point{.summary = "", .source = ""};
  static const Catalog catalog(
      {{.file = {}, .kind = Kind::sampler, .name = "exact", .version = "1", .sampler = &exact},
       {.file = {}, .kind = Kind::sampler, .name = "point", .version = "1", .sampler = &point},
       {.file = {}, .kind = Kind::scene, .name = "terrain", .version = "1", .scene = &terrain}});
  static const Vocabulary result{&catalog, vocabulary().metrics, vocabulary().lookups, vocabulary().pictures};
  return result;
}

TEST_CASE("a reference needs to fit the exact scene only") {
  const ExperimentFolder folder;
  const auto file =
      folder.file("edges/experiment.json", experiment_with({R"("scenes": ["terrain"])", R"("samplers": ["point"])",
                                                            R"("reference": "exact")", R"("metrics": ["error"])"}));
  CHECK(read_experiment(file, with_exact_terrain(), {}).reference->name == "exact");
}

TEST_CASE("a contender that fits the exact scene only is told under which settings it would do") {
  const Catalog& catalog = *with_exact_terrain().catalog;
  const Plugin* terrain = catalog.find(Kind::scene, "terrain");
  const Plugin* exact = catalog.find(Kind::sampler, "exact");
  CHECK(mismatch({"hills", terrain, Settings(terrain->parameters())}, {"exact", exact, Settings(), "nearest"},
                 with_exact_terrain()) ==
        "\"exact\" asks for polygons, which scene \"hills\" (terrain) does not have; it does with levels=none");
}

}  // namespace
}  // namespace moire::test
