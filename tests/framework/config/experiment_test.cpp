#include "config/experiment.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "message_of.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

TEST_CASE("the shortest experiment gets every default") {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(experiment_with({}));
  CHECK(experiment.name == "edges");
  CHECK(experiment.question == "Which is best?");
  CHECK(experiment.image == ImageSize{64, 48});
  REQUIRE(experiment.scenes.size() == 1);
  CHECK(experiment.scenes[0].name == "heightfield");
  CHECK(experiment.scenes[0].plugin->name == "heightfield");
  CHECK(experiment.scenes[0].settings.real("view.pitch_deg") == -20);
  REQUIRE(experiment.samplers.size() == 1);
  CHECK(experiment.samplers[0].name == "point");
  CHECK(experiment.samplers[0].lookup == "nearest");
  CHECK_FALSE(experiment.reference);
  CHECK(experiment.seed == 1);
  REQUIRE(experiment.metrics.size() == 1);
  CHECK(experiment.metrics[0].name == "error");
}

TEST_CASE("an experiment may be named by its file or its folder, and end in a slash") {
  const ExperimentFolder folder;
  const auto file = folder.file("edges/experiment.json", experiment_with({}));
  for (const auto& path : {file, folder.path() / "edges", folder.path() / "edges/"}) {
    CHECK(read_experiment(path, vocabulary(), {}).name == "edges");
  }
}

TEST_CASE("a path without an experiment says what an experiment is") {
  const ExperimentFolder folder;
  const auto message = [&](const std::filesystem::path& path) {
    return message_of([&] { read_experiment(path, vocabulary(), {}); });
  };
  CHECK(message("no/such/folder") ==
        "no/such/folder: no such file or folder; an experiment is a JSON file, or a folder with an experiment.json");
  CHECK(message(folder.path()) == folder.path().string() +
                                      ": has no experiment.json; an experiment is a JSON file, or a folder with one of "
                                      "that name");
}

TEST_CASE("a file that is empty, no JSON or no object is refused") {
  const ExperimentFolder folder;
  CHECK(folder.problems("") == "edges/experiment.json:1: is empty; a JSON object is expected");
  CHECK(folder.problems("{") ==
        "edges/experiment.json:1: the file ends too early; a '}' is missing for the '{' of line 1");
  CHECK(folder.problems("[]") ==
        "edges/experiment.json:1: is a list; an experiment is an object with question, image, scenes, samplers, "
        "reference, seed, frames, metrics, pictures, keep_images");
}

TEST_CASE("keys that must be there are asked for, all at once") {
  const ExperimentFolder folder;
  CHECK(folder.problems("\n{}") ==
        "edges/experiment.json:2: has no \"question\"; say in a sentence what it shall find out\n"
        "edges/experiment.json:2: has no \"image\"; write such as \"image\": {\"width\": 400, \"height\": 400}\n"
        "edges/experiment.json:2: has no \"scenes\"; name one at least, such as \"scenes\": [\"cartoon\"]\n"
        "edges/experiment.json:2: has no \"samplers\"; name one at least, such as \"samplers\": [\"area\"]");
}

TEST_CASE("keys that nobody knows are refused with the nearest known one") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with({R"("sampler": [])", R"("zebra": 1)", R"("$schema": "x.json")"}) ==
      "edges/experiment.json:6: sampler: unknown key; did you mean \"samplers\"? an experiment takes question, image, "
      "scenes, samplers, reference, seed, frames, metrics, pictures, keep_images\n"
      "edges/experiment.json:7: zebra: unknown key; an experiment takes question, image, scenes, samplers, reference, "
      "seed, frames, metrics, pictures, keep_images");
}

TEST_CASE("values of the experiment's own keys are checked") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with(
            {R"("question": 3)", R"("image": {"width": 0, "height": 16385, "depth": 1})", R"("seed": -1)"}) ==
        "edges/experiment.json:2: question: is 3; \"question\" takes a text\n"
        "edges/experiment.json:3: image.width: is 0; \"image\" takes 1 to 16384 pixels\n"
        "edges/experiment.json:3: image.height: is 16385; \"image\" takes 1 to 16384 pixels\n"
        "edges/experiment.json:3: image.depth: unknown key; \"image\" takes width, height\n"
        "edges/experiment.json:6: seed: is -1; \"seed\" takes 0 to 9007199254740992");
  CHECK(folder.problems_with({R"("image": {"width": 4.0})"}) ==
        "edges/experiment.json:3: image: has no \"height\"; an image has a \"width\" and a \"height\"\n"
        "edges/experiment.json:3: image.width: is 4.0; \"image\" takes a whole number, 1 to 16384 pixels");
  CHECK(folder.problems_with({R"("image": [64, 48])"}) ==
        "edges/experiment.json:3: image: is a list; an image has a \"width\" and a \"height\"");
  CHECK(folder.problems_with({R"("seed": 9007199254740993)"}) ==
        "edges/experiment.json:6: seed: is 9007199254740993; \"seed\" takes 0 to 9007199254740992");
}

TEST_CASE("the largest seed and image are allowed") {
  const ExperimentFolder folder;
  const Experiment experiment =
      folder.read(experiment_with({R"("seed": 9007199254740992)", R"("image": {"width": 16384, "height": 1})"}));
  CHECK(experiment.seed == std::uint64_t{1} << 53);
  CHECK(experiment.image == ImageSize{16384, 1});
}

TEST_CASE("scenes and samplers may be one name, one object or a list of both") {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(
      experiment_with({R"("scenes": "heightfield")", R"("samplers": {"type": "point"})", R"("metrics": "speed")"}));
  CHECK(experiment.scenes.front().name == "heightfield");
  CHECK(experiment.samplers.front().name == "point");
  CHECK(experiment.metrics.front().name == "speed");
}

TEST_CASE("lists that are none, or empty, are refused") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": 3)", R"("samplers": [])", R"("metrics": null)"}) ==
        "edges/experiment.json:4: scenes: is 3; it takes a list of names or objects\n"
        "edges/experiment.json:5: samplers: is an empty list; name one at least\n"
        "edges/experiment.json:6: metrics: is null; it takes a list of names or objects");
}

TEST_CASE("entries that are no plugin's are refused with those that are known") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": [7, {"label": "x"}, {"type": 1}])",
                              R"("samplers": ["supersampel", {"type": "quincunx"}])"}) ==
        "edges/experiment.json:4: scenes[0]: is 7; a scene is a name, or an object with a \"type\"\n"
        "edges/experiment.json:4: scenes[1]: has no \"type\"; a scene is a name, or an object with a \"type\"\n"
        "edges/experiment.json:4: scenes[2].type: is 1; a type is the name of a scene\n"
        "edges/experiment.json:5: samplers[0].type: there is no sampler \"supersampel\"; did you mean "
        "\"supersample\"? known are area, bilinear, jittered, point, supersample\n"
        "edges/experiment.json:5: samplers[1].type: there is no sampler \"quincunx\"; known are area, bilinear, "
        "jittered, point, "
        "supersample");
}

TEST_CASE("the reference is the best there is, or a sampler of one's own") {
  const ExperimentFolder folder;
  CHECK_FALSE(folder.read(experiment_with({R"("reference": "auto")"})).reference);
  const auto reference = folder.read(experiment_with({R"("reference": {"type": "supersample", "n": 64})"})).reference;
  REQUIRE(reference);
  CHECK(reference->name == "supersample[n=64]");
  CHECK(reference->settings.integer("n") == 64);
  CHECK(folder.read(experiment_with({R"("reference": "point")"})).reference->name == "point");
}

TEST_CASE("a reference is one sampler that exists") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("reference": {"type": "supersample", "n": [4, 8]})"}) ==
        "edges/experiment.json:6: reference.n: is a list; it takes one value here");
  CHECK(folder.problems_with({R"("reference": ["auto"])"}) ==
        "edges/experiment.json:6: reference: is a list; a sampler is a name, or an object with a \"type\"");
  CHECK(folder.problems_with({R"("reference": "pont")"}) ==
        "edges/experiment.json:6: reference.type: there is no sampler \"pont\"; did you mean \"point\"? known are "
        "area, bilinear, jittered, point, supersample");
}

TEST_CASE("what a scene itself objects to is reported at the scene, for each of its grid") {
  const ExperimentFolder folder;
  folder.file("edges/a.png", "");
  CHECK(folder.problems_with(
            {R"("scenes": {"type": "heightfield", "height": ["", "a.png"], "generate": ["fractal", "nothing"]})"}) ==
        "edges/experiment.json:4: scenes[0]: \"heightfield[height=a,generate=fractal]\" cannot be made: height and "
        "generate exclude each other");
}

TEST_CASE("a sampler whose default lookup this program lacks is refused") {
  const ExperimentFolder folder;
  folder.file("edges/experiment.json", experiment_with({R"("samplers": ["bilinear"])"}));
  Vocabulary poor = vocabulary();
  poor.lookups = poor.lookups.first(2);
  const std::string file = (folder.path() / "edges/experiment.json").string();
  CHECK(message_of([&] { read_experiment(file, poor, {}); }) ==
        file +
            ":5: samplers[0]: there is no lookup \"bilinear\", the default of \"bilinear\"; known are nearest, "
            "linear_across");
}

TEST_CASE("everything that is wrong is reported together, by file and line") {
  const ExperimentFolder folder;
  folder.file("configs/plain.json", "{\n\"type\": \"heightfield\",\n\"hierarchy\": 1\n}");
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/plain.json"}])", R"("samplers": ["pont",
    {"type": "area", "layuot": "radial", "n": 1},
    {"type": "supersample", "n": 0}])",
                              R"("seed": "x")"}) ==
        "configs/plain.json:3: scenes[0].hierarchy: is 1; \"heightfield\" takes true or false\n"
        "edges/experiment.json:5: samplers[0].type: there is no sampler \"pont\"; did you mean \"point\"? known are "
        "area, bilinear, jittered, point, supersample\n"
        "edges/experiment.json:6: samplers[1].layuot: unknown key; did you mean \"layout\"? \"area\" takes method, "
        "layout, closed, blur, lookup, mipmap, label\n"
        "edges/experiment.json:6: samplers[1].n: unknown key; \"area\" takes method, layout, closed, blur, lookup, "
        "mipmap, label\n"
        "edges/experiment.json:7: samplers[2].n: is 0; \"supersample\" takes 1 to 256 points\n"
        "edges/experiment.json:8: seed: is \"x\"; \"seed\" takes a whole number, 0 to 9007199254740992");
}

}  // namespace
}  // namespace moire::test
