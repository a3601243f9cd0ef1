#include "config/overrides.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

Experiment read_with(const std::vector<std::string>& sets, const std::vector<std::string>& lines = {}) {
  const ExperimentFolder folder;
  folder.file("configs/steep.json", R"({"type": "heightfield", "label": "steep", "view": {"pitch_deg": -60}})");
  return folder.read(experiment_with(lines), {.sets = sets, .only = ""});
}

TEST_CASE("what is set replaces what the file says, the last one wins") {
  CHECK(read_with({"image.width=100", "image.width=32"}).image == ImageSize{32, 48});
  CHECK(read_with({"question=Why?"}).question == "Why?");
  CHECK(read_with({"question=a=b"}).question == "a=b");
  CHECK(read_with({"image={\"width\": 5, \"height\": 6}"}).image == ImageSize{5, 6});
}

TEST_CASE("a member that the file does not have is made") {
  CHECK(read_with({"seed=7"}).seed == 7);
  CHECK(read_with({"scenes[0].view.pitch_deg=-5"}).scenes[0].settings.real("view.pitch_deg") == -5);
}

TEST_CASE("a path leads into entries that are names, and into lists of one that are written without brackets") {
  const auto experiment =
      read_with({"samplers[0].lookup=bilinear", "scenes[0].label=x"}, {R"("scenes": "heightfield")"});
  CHECK(experiment.samplers[0].lookup == "bilinear");
  CHECK(experiment.scenes[0].name == "x");
}

TEST_CASE("names, lists and grids can be set") {
  CHECK(read_with({"samplers=supersample"}).samplers[0].name == "supersample");
  CHECK(read_with({"samplers[0]=area"}).samplers[0].name == "area");
  CHECK(read_with({"samplers[0]={\"type\": \"supersample\", \"n\": [1, 2, 3]}"}).samplers.size() == 3);
  CHECK(read_with({"reference=point"}).reference->name == "point");
}

TEST_CASE("what is set goes before a used file, and the used file itself can be set") {
  const auto experiment = read_with({"scenes[0]={\"use\": \"configs/steep.json\"}", "scenes[0].view.height=9"});
  CHECK(experiment.scenes[0].name == "steep");
  CHECK(experiment.scenes[0].settings.real("view.pitch_deg") == -60);
  CHECK(experiment.scenes[0].settings.real("view.height") == 9);
}

TEST_CASE("a file that is set is looked for where the program was started") {
  const ExperimentFolder folder;
  const std::string file = folder.file("data/a.png", "").string();
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path() / "data");
  const Experiment experiment = folder.read(experiment_with({}), {.sets = {"scenes[0].height=a.png"}, .only = ""});
  std::filesystem::current_path(before);
  CHECK(experiment.scenes[0].settings.text("height") == file);
}

TEST_CASE("wrong values are reported as set there") {
  const ExperimentFolder folder;
  CHECK(folder.problems_of_sets({"image.width=0", "imag.width=3", "samplers[0].n={\"a\": 1, \"a\": 2}"}) ==
        "--set imag.width=3: imag: unknown key; did you mean \"image\"? an experiment takes question, image, scenes, "
        "samplers, reference, seed, frames, metrics, pictures, keep_images\n"
        "--set image.width=0: image.width: is 0; \"image\" takes 1 to 16384 pixels\n"
        "--set samplers[0].n={\"a\": 1, \"a\": 2}: samplers[0].n.a: repeated key; keep one of them\n"
        "--set samplers[0].n={\"a\": 1, \"a\": 2}: samplers[0].n: unknown key; \"point\" takes lookup, mipmap, label");
}

TEST_CASE("a path that leads nowhere is named") {
  const ExperimentFolder folder;
  CHECK(folder.problems_of_sets({"question.x=1", "scenes[1].label=x", "image[0]=1", "scenes.type=cartoon"}) ==
        "--set image[0]=1: leads nowhere: \"image\" is no list\n"
        "--set question.x=1: leads nowhere: \"question\" has no members such as \"x\"\n"
        "--set scenes.type=cartoon: leads nowhere: \"scenes\" has no members such as \"type\"\n"
        "--set scenes[1].label=x: leads nowhere: \"scenes\" has 1 item, counted from 0");
}

TEST_CASE("what is no path is refused") {
  const ExperimentFolder folder;
  CHECK(folder.problems_of_sets({"seed"}) == "--set seed: has no \"=\"; write --set PATH=VALUE");
  for (const std::string path :
       {"", ".seed", "seed.", "a..b", "[0]", "a[x]", "a[1", "a[]", "a[-1]", "a[0]b", "a[99999999999999999999]"}) {
    CHECK(folder.problems_of_sets({path + "=1"}) ==
          "--set " + path + "=1: \"" + path + "\" is no path; write such as samplers[1].n");
  }
  CHECK(folder.problems_of_sets({"question=\xff"}) == "--set question=\xff: question: its value is not in UTF-8");
}

}  // namespace
}  // namespace moire::test
