// What belongs to a lookup or a filter: read where that is chosen, refused or dropped where it is not.
#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

std::vector<SamplerChoice> samplers(const std::string& entries) {
  const ExperimentFolder folder;
  return folder.read(experiment_with({R"("samplers": )" + entries})).samplers;
}

std::vector<std::string> names(const std::string& entries) {
  std::vector<std::string> result;
  for (const SamplerChoice& sampler : samplers(entries)) result.push_back(sampler.name);
  return result;
}

// Of these samplers, on line 5.
std::string complaint(const std::string& entries) {
  const ExperimentFolder folder;
  return folder.problems_with({R"("samplers": )" + entries});
}

using Names = std::vector<std::string>;
const std::string line = "edges/experiment.json:5: ";

}  // namespace

TEST_CASE("a pattern takes a filter and its options, and what is not given has its default") {
  const auto made = samplers(R"(["jittered", {"type": "jittered", "filter": "mitchell", "mitchell": {"c": 0.125}}])");
  REQUIRE(made.size() == 2);
  CHECK(made[0].filter == "box");
  CHECK(made[0].options.values().count("mitchell.b") == 0);
  CHECK(made[1].filter == "mitchell");
  CHECK(made[1].options.real("mitchell.b") == 0.25);
  CHECK(made[1].options.real("mitchell.c") == 0.125);
  CHECK(made[1].options.values().count("tent.radius") == 0);
}

TEST_CASE("a lookup's options are read in the same way, by samplers that take no filter too") {
  const auto made = samplers(R"([{"type": "point", "lookup": "mipmap", "mipmap": {"bias": -1, "level": "min"}}])");
  REQUIRE(made.size() == 1);
  CHECK(made[0].lookup == "mipmap");
  CHECK(made[0].options.real("mipmap.bias") == -1);
  CHECK(made[0].options.text("mipmap.level") == "min");
}

TEST_CASE("options are shown in names like parameters, where they have an effect") {
  CHECK(
      names(
          R"([{"type": "jittered", "n": 4, "layout": "grid", "filter": "mitchell"}, {"type": "jittered", "n": 2}])") ==
      Names{"jittered[n=4,layout=grid,filter=mitchell]", "jittered[n=2,layout=column,filter=box]"});
  CHECK(names(R"([{"type": "jittered", "filter": "mitchell", "mitchell": {"b": 0}}])") ==
        Names{"jittered[filter=mitchell,mitchell.b=0]"});
}

TEST_CASE("in a grid each choice keeps the options that have an effect on it, and equal ones become one") {
  CHECK(names(R"([{"type": "jittered", "filter": ["box", "mitchell", "tent"], "mitchell": {"b": [0, 1]}}])") ==
        Names{"jittered[filter=box]", "jittered[filter=mitchell,mitchell.b=0]",
              "jittered[filter=mitchell,mitchell.b=1]", "jittered[filter=tent]"});
  CHECK(names(R"([{"type": "point", "lookup": ["nearest", "mipmap"], "mipmap": {"bias": [0, 0.5]}}])") ==
        Names{"point[lookup=nearest]", "point[lookup=mipmap,mipmap.bias=0]", "point[lookup=mipmap,mipmap.bias=0.5]"});
  CHECK(names(R"([{"type": "jittered", "filter": ["tent", "mitchell"], "lookup": ["nearest", "mipmap"],
                   "mipmap": {"bias": [1, 2]}, "tent": {"radius": 2}}])") ==
        Names{"jittered[lookup=nearest,filter=tent,tent.radius=2]", "jittered[lookup=nearest,filter=mitchell]",
              "jittered[lookup=mipmap,mipmap.bias=1,filter=tent,tent.radius=2]",
              "jittered[lookup=mipmap,mipmap.bias=1,filter=mitchell]",
              "jittered[lookup=mipmap,mipmap.bias=2,filter=tent,tent.radius=2]",
              "jittered[lookup=mipmap,mipmap.bias=2,filter=mitchell]"});
}

TEST_CASE("an option that has an effect on no choice of its entry is refused") {
  CHECK(
      complaint(R"([{"type": "jittered", "mitchell": {"b": 0}}])") ==
      line +
          "samplers[0].mitchell.b: has no effect without \"mitchell\" as lookup or filter; choose that or remove this");
  CHECK(
      complaint(R"([{"type": "jittered", "filter": ["box", "tent"], "mitchell": {"b": [0, 1]}}])") ==
      line +
          "samplers[0].mitchell.b: has no effect without \"mitchell\" as lookup or filter; choose that or remove this");
  CHECK(
      complaint(R"([{"type": "point", "mipmap": {"bias": 1}}])") ==
      line +
          "samplers[0].mipmap.bias: has no effect without \"mipmap\" as lookup or filter; choose that or remove this");
}

TEST_CASE("options have types, ranges and known names") {
  CHECK(complaint(R"([{"type": "jittered", "filter": "mitchel"}])") ==
        line + "samplers[0].filter: is \"mitchel\"; did you mean \"mitchell\"? \"jittered\" takes box, tent, mitchell");
  CHECK(complaint(R"([{"type": "jittered", "filter": "tent", "tent": {"radius": 5}}])") ==
        line + "samplers[0].tent.radius: is 5; \"jittered\" takes 0.5 to 4 pixels");
  CHECK(complaint(R"([{"type": "jittered", "filter": "tent", "tent": {"width": 1}}])") ==
        line + "samplers[0].tent.width: unknown key; \"tent\" takes radius");
}

TEST_CASE("a sampler that weighs pixels itself says so when it is given a filter") {
  CHECK(complaint(R"([{"type": "area", "filter": "mitchell"}])") ==
        line +
            "samplers[0].filter: is \"mitchell\", but \"area\" weighs pixels itself and takes no filter; remove this");
  CHECK(complaint(R"([{"type": "point", "filtr": "box"}])") ==
        line + "samplers[0].filtr: unknown key; \"point\" takes lookup, mipmap, label");
}

TEST_CASE("the request says of options what has an effect, and reading it gives the same again") {
  const ExperimentFolder folder;
  const Experiment made = folder.read(experiment_with(
      {R"("samplers": [{"type": "jittered", "filter": ["box", "mitchell"], "mitchell": {"b": 0.5}}, "point"])"}));
  const auto& entries = made.request.at("samplers");
  CHECK(entries[0].dump() == R"({"type":"jittered","label":"jittered[filter=box]","n":4,"layout":"column",)"
                             R"("lookup":"nearest","filter":"box"})");
  CHECK(entries[1].dump() ==
        R"({"type":"jittered","label":"jittered[filter=mitchell,mitchell.b=0.5]","n":4,"layout":"column",)"
        R"("lookup":"nearest","filter":"mitchell","mitchell":{"b":0.5,"c":0.5}})");
  const Experiment again = folder.read(made.request.dump());
  REQUIRE(again.samplers.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(again.samplers[k].name == made.samplers[k].name);
    CHECK(again.samplers[k].filter == made.samplers[k].filter);
    CHECK(again.samplers[k].options == made.samplers[k].options);
  }
}

}  // namespace moire::test
