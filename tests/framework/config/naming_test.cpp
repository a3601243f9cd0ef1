#include "config/naming.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

// The names of the contenders that these samplers make.
std::vector<std::string> names(const std::string& samplers) {
  const ExperimentFolder folder;
  std::vector<std::string> result;
  for (const auto& sampler : folder.read(experiment_with({R"("samplers": )" + samplers})).samplers) {
    result.push_back(sampler.name);
  }
  return result;
}

using Names = std::vector<std::string>;

TEST_CASE("a name shows what is not the default") {
  CHECK(names(R"(["supersample", "point"])") == Names{"supersample", "point"});
  CHECK(names(R"([{"type": "supersample", "n": 4, "layout": "grid"}])") == Names{"supersample[layout=grid]"});
  CHECK(names(R"([{"type": "area", "closed": true, "blur": 2}])") == Names{"area[closed=true,blur=2]"});
  CHECK(names(R"([{"type": "area", "blur": 0.1}])") == Names{"area[blur=0.1]"});
}

TEST_CASE("a name shows the default, too, where contenders of the type differ in it") {
  CHECK(names(R"([{"type": "supersample", "n": [2, 4]}, "point"])") ==
        Names{"supersample[n=2]", "supersample[n=4]", "point"});
  CHECK(names(R"(["supersample", {"type": "supersample", "layout": "grid"}])") ==
        Names{"supersample[layout=column]", "supersample[layout=grid]"});
}

TEST_CASE("a lookup is shown like a parameter, compared with the default of the sampler") {
  CHECK(names(R"([{"type": "point", "lookup": "linear_across"}])") == Names{"point[lookup=linear_across]"});
  CHECK(names(R"([{"type": "bilinear", "lookup": "bilinear"}])") == Names{"bilinear"});
  CHECK(names(R"([{"type": "point", "lookup": ["nearest", "bilinear"]}])") ==
        Names{"point[lookup=nearest]", "point[lookup=bilinear]"});
}

TEST_CASE("a label is the name; with a grid, the grid's parameters follow") {
  CHECK(names(R"([{"type": "supersample", "n": 8, "label": "eight points"}])") == Names{"eight points"});
  CHECK(names(R"([{"type": "supersample", "n": [4, 8], "layout": "grid", "label": "many"}])") ==
        Names{"many[n=4]", "many[n=8]"});
}

TEST_CASE("scenes are named by the same rule, files by their stem") {
  const ExperimentFolder folder;
  folder.file("edges/rainier.16.png", "");
  const auto scenes = folder
                          .read(experiment_with({R"("scenes": ["heightfield",
      {"type": "heightfield", "height": "rainier.16.png"}, {"type": "cartoon", "label": "Bilder, \u00fc #1"}])"}))
                          .scenes;
  REQUIRE(scenes.size() == 3);
  CHECK(scenes[0].name == "heightfield[height=none]");
  CHECK(scenes[1].name == "heightfield[height=rainier.16]");
  CHECK(scenes[2].name == "Bilder, \u00fc #1");
}

TEST_CASE("two of one name are refused, the line of the first named") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with({R"("samplers": ["point",
    {"type": "area", "label": "point"}, {"type": "supersample", "n": [2, 2]}])"}) ==
      "edges/experiment.json:6: samplers[1]: is a second sampler called \"point\" (the first is samplers[0], line 5); "
      "give one of them a \"label\"\n"
      "edges/experiment.json:6: samplers[2]: is a second sampler called \"supersample[n=2]\" (the first is "
      "samplers[2], line 6); give one of them a \"label\"");
}

TEST_CASE("a name that can be no folder's is refused") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("samplers": [{"type": "point", "label": "a/b"}, {"type": "point", "label": "a\tb"},
    {"type": "point", "label": ""}, {"type": "point", "label": ".."}])",
                              R"("scenes": [{"type": "heightfield", "credit": "a/b"}])"}) ==
        "edges/experiment.json:4: scenes[0]: is called \"heightfield[credit=a/b]\"; a name is a folder's too, without "
        "\"/\": give it another \"label\"\n"
        "edges/experiment.json:5: samplers[0].label: is \"a/b\"; a name is a folder's too, without \"/\"\n"
        "edges/experiment.json:5: samplers[1].label: is \"a\\tb\"; a name is a folder's too, without control "
        "characters\n"
        "edges/experiment.json:6: samplers[2].label: is \"\"; a name is a folder's too\n"
        "edges/experiment.json:6: samplers[3].label: is \"..\"; a name is a folder's too");
  CHECK(name_problem(std::string(255, 'a')) == "");
  CHECK(name_problem(std::string(256, 'a')) == "a name is a folder's too, of at most 255 bytes");
}

}  // namespace
}  // namespace moire::test
