#include "config/settings_reader.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

TEST_CASE("lists are a grid, and grids multiply in the order of the table") {
  const ExperimentFolder folder;
  const auto samplers = folder
                            .read(experiment_with({R"("samplers": [{"type": "supersample",
      "layout": ["column", "grid"], "n": [2, 8], "lookup": ["nearest", "bilinear"]}])"}))
                            .samplers;
  REQUIRE(samplers.size() == 8);
  CHECK(samplers[0].name == "supersample[n=2,layout=column,lookup=nearest]");
  CHECK(samplers[1].name == "supersample[n=2,layout=column,lookup=bilinear]");
  CHECK(samplers[2].name == "supersample[n=2,layout=grid,lookup=nearest]");
  CHECK(samplers[7].name == "supersample[n=8,layout=grid,lookup=bilinear]");
  CHECK(samplers[7].settings.integer("n") == 8);
  CHECK(samplers[7].settings.text("layout") == "grid");
  CHECK(samplers[7].lookup == "bilinear");
  CHECK(samplers[7].settings.values().size() == 2);
}

TEST_CASE("scenes have grids too, and dotted parameters are members of objects") {
  const ExperimentFolder folder;
  const auto scenes =
      folder
          .read(experiment_with(
              {R"("scenes": [{"type": "heightfield", "view": {"pitch_deg": [-40, -5.5], "height": 7}}])"}))
          .scenes;
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].name == "heightfield[view.pitch_deg=-40,view.height=7]");
  CHECK(scenes[1].settings.real("view.pitch_deg") == -5.5);
  CHECK(scenes[1].settings.real("view.height") == 7);
}

TEST_CASE("the items of a grid are checked one by one") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("samplers": [{"type": "supersample", "n": [1, 0, [2],
     "4"], "layout": []}])"}) ==
        "edges/experiment.json:5: samplers[0].n[1]: is 0; \"supersample\" takes 1 to 256 points\n"
        "edges/experiment.json:5: samplers[0].n[2]: is a list; \"supersample\" takes a whole number, 1 to 256 points\n"
        "edges/experiment.json:6: samplers[0].n[3]: is \"4\"; \"supersample\" takes a whole number, 1 to 256 points\n"
        "edges/experiment.json:6: samplers[0].layout: is an empty list; a grid has at least one value");
}

TEST_CASE("a grid that would fill the memory is refused") {
  const ExperimentFolder folder;
  std::string many = "0";
  for (int i = 1; i < 101; ++i) many.append(",").append(std::to_string(i / 2.0));
  CHECK(folder.problems_with({R"("scenes": [{"type": "heightfield", "view": {"pitch_deg": [)" + many +
                              R"(], "height": [)" + many + "]}}]"}) ==
        "edges/experiment.json:4: scenes[0]: its lists make too many combinations; at most 10000 are allowed");
}

TEST_CASE("unknown keys name the nearest, in groups too") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": [{"type": "heightfield", "veiw": {}, "view": {"pich_deg": 1, "label": 2},
     "view.height": 3, "lookup": "nearest"}])",
                              R"("samplers": [{"type": "point", "lable": "a"}])"}) ==
        "edges/experiment.json:4: scenes[0].veiw: unknown key; did you mean \"view\"? \"heightfield\" takes height, "
        "generate, hierarchy, view, sky, credit, label\n"
        "edges/experiment.json:4: scenes[0].view.pich_deg: unknown key; did you mean \"pitch_deg\"? \"view\" takes "
        "pitch_deg, height\n"
        "edges/experiment.json:4: scenes[0].view.label: unknown key; \"view\" takes pitch_deg, height\n"
        "edges/experiment.json:5: scenes[0].view.height: unknown key; \"heightfield\" takes height, generate, "
        "hierarchy, view, sky, credit, label\n"
        "edges/experiment.json:5: scenes[0].lookup: unknown key; \"heightfield\" takes height, generate, hierarchy, "
        "view, sky, credit, label\n"
        "edges/experiment.json:6: samplers[0].lable: unknown key; did you mean \"label\"? \"point\" takes lookup, "
        "mipmap, label");
}

TEST_CASE("a group that is no object is refused") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": [{"type": "heightfield", "view": -5}])"}) ==
        "edges/experiment.json:4: scenes[0].view: is -5; it takes an object with pitch_deg, height");
}

}  // namespace
}  // namespace moire::test
