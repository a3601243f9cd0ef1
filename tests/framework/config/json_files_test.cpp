#include "config/json_files.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "message_of.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

TEST_CASE("a used file is filled in under the entry's own keys, object by object") {
  const ExperimentFolder folder;
  folder.file("configs/steep.json", R"({"type": "heightfield", "label": "steep", "hierarchy": true,
      "view": {"pitch_deg": [-60, -70], "height": 50}})");
  const auto scenes =
      folder.read(experiment_with({R"("scenes": [{"use": "configs/steep.json", "view": {"pitch_deg": -80}}])"})).scenes;
  REQUIRE(scenes.size() == 1);
  CHECK(scenes[0].name == "steep");
  CHECK(scenes[0].settings.flag("hierarchy"));
  CHECK(scenes[0].settings.real("view.pitch_deg") == -80);
  CHECK(scenes[0].settings.real("view.height") == 50);
}

TEST_CASE("a used file is looked for beside the experiment first, then from the project's root") {
  const ExperimentFolder folder;
  folder.file("sampler.json", R"({"type": "supersample"})");
  const std::string text = experiment_with({R"("samplers": {"use": "sampler.json"})"});
  CHECK(folder.read(text).samplers[0].name == "supersample");
  folder.file("edges/sampler.json", R"({"type": "point"})");
  CHECK(folder.read(text).samplers[0].name == "point");
}

TEST_CASE("the reference may use a file too") {
  const ExperimentFolder folder;
  folder.file("configs/fine.json", R"({"type": "supersample", "n": 64})");
  CHECK(folder.read(experiment_with({R"("reference": {"use": "configs/fine.json"})"})).reference->name ==
        "supersample[n=64]");
}

TEST_CASE("problems point into the file that they are in") {
  const ExperimentFolder folder;
  folder.file("configs/a.json",
              "{\"type\": \"heightfield\",\n\"view\": {\"height\": 1,\n\"height\": 2},\n\"skye\": 1}");
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/a.json",
      "view": {"pitch_deg": 91}}])"}) ==
        "configs/a.json:3: scenes[0].view.height: repeated key (first on line 2); keep one of them\n"
        "configs/a.json:4: scenes[0].skye: unknown key; did you mean \"sky\"? \"heightfield\" takes height, generate, "
        "hierarchy, view, sky, credit, label\n"
        "edges/experiment.json:5: scenes[0].view.pitch_deg: is 91; \"heightfield\" takes -90 to 90 degrees");
}

TEST_CASE("a fault of a file that several entries use is reported once") {
  const ExperimentFolder folder;
  folder.file("configs/a.json", "{\"type\": \"heightfield\",\n\"sky\": [3, 3]}");
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/a.json"}, {"use": "configs/a.json", "label": "b"}])"}) ==
        "configs/a.json:2: scenes[0].sky[0]: is 3; \"heightfield\" takes a colour such as \"#3fa0ff\"\n"
        "configs/a.json:2: scenes[0].sky[1]: is 3; \"heightfield\" takes a colour such as \"#3fa0ff\"");
}

TEST_CASE("a used file that is missing, none, no JSON or no object is refused, and nothing more is said of its entry") {
  const ExperimentFolder folder;
  folder.file("configs/list.json", "\n[]");
  folder.file("configs/broken.json", "{\n");
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/no.json"}, {"use": 3}, {"use": "configs"},
    {"use": "configs/list.json"}, {"use": "configs/broken.json", "n": 3}])"}) ==
        "configs/broken.json:1: scenes[4]: the file ends too early; a '}' is missing for the '{' of line 1\n"
        "configs/list.json:2: scenes[3]: is a list; a used file holds an object\n"
        "edges/experiment.json:4: scenes[0].use: is \"configs/no.json\", but there is no such file (looked for "
        "edges/configs/no.json, configs/no.json)\n"
        "edges/experiment.json:4: scenes[1].use: is 3; \"use\" takes the path of a JSON file\n"
        "edges/experiment.json:4: scenes[2].use: is \"configs\", but there is no such file (looked for edges/configs, "
        "configs)");
}

TEST_CASE("a used file cannot use another, so there are no circles") {
  const ExperimentFolder folder;
  folder.file("configs/a.json", "{\"type\": \"heightfield\",\n\"use\": \"configs/a.json\"}");
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/a.json"}])"}) ==
        "configs/a.json:2: scenes[0].use: a used file cannot use another; write its members here");
}

TEST_CASE("a bomb of brackets in a used file does no harm") {
  const ExperimentFolder folder;
  folder.file("configs/a.json", std::string(100000, '['));
  CHECK(folder.problems_with({R"("scenes": [{"use": "configs/a.json"}])"}) ==
        "configs/a.json:1: scenes[0]: is nested more than 100 levels deep");
}

TEST_CASE("files are shown as the user gave the experiment, relative to where the program was started") {
  const ExperimentFolder folder;
  folder.file("configs/a.json", "[]");
  folder.file("edges/experiment.json", experiment_with({R"("scenes": {"use": "configs/a.json"})", R"("seed": -1)"}));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path() / "data");
  const std::string message = message_of([&] { read_experiment("../edges", vocabulary(), {}); });
  std::filesystem::current_path(before);
  CHECK(message ==
        "../configs/a.json:1: scenes[0]: is a list; a used file holds an object\n"
        "../edges/experiment.json:6: seed: is -1; \"seed\" takes 0 to 9007199254740992");
}

}  // namespace
}  // namespace moire::test
