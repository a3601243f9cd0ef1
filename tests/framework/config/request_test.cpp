// The request is an experiment with nothing left to choose. It must never give anything but the experiment it is of:
// results are run again from it.
#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

void check_same(const SamplerChoice& a, const SamplerChoice& b) {
  CHECK(a.name == b.name);
  CHECK(a.plugin == b.plugin);
  CHECK(a.settings == b.settings);
  CHECK(a.lookup == b.lookup);
}

void check_same(const Frames& a, const Frames& b) {
  CHECK(a.count == b.count);
  CHECK(a.still == b.still);
  REQUIRE(a.tracks.size() == b.tracks.size());
  for (std::size_t i = 0; i < a.tracks.size(); ++i) {
    CHECK(a.tracks[i].parameter == b.tracks[i].parameter);
    REQUIRE(a.tracks[i].keys.size() == b.tracks[i].keys.size());
    for (std::size_t k = 0; k < a.tracks[i].keys.size(); ++k) {
      CHECK(a.tracks[i].keys[k].frame == b.tracks[i].keys[k].frame);
      CHECK(a.tracks[i].keys[k].value == b.tracks[i].keys[k].value);
    }
  }
}

void check_same(const std::vector<PassChoice>& a, const std::vector<PassChoice>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].name == b[i].name);
    CHECK(a[i].settings == b[i].settings);
  }
}

void check_same(const Experiment& a, const Experiment& b) {
  CHECK(a.name == b.name);
  CHECK(a.question == b.question);
  CHECK(a.image == b.image);
  CHECK(a.seed == b.seed);
  CHECK(a.request.dump() == b.request.dump());
  REQUIRE(a.scenes.size() == b.scenes.size());
  for (std::size_t i = 0; i < a.scenes.size(); ++i) {
    CHECK(a.scenes[i].name == b.scenes[i].name);
    CHECK(a.scenes[i].plugin == b.scenes[i].plugin);
    CHECK(a.scenes[i].settings == b.scenes[i].settings);
  }
  REQUIRE(a.samplers.size() == b.samplers.size());
  for (std::size_t i = 0; i < a.samplers.size(); ++i) check_same(a.samplers[i], b.samplers[i]);
  REQUIRE(a.reference.has_value() == b.reference.has_value());
  if (a.reference) check_same(*a.reference, *b.reference);
  check_same(a.frames, b.frames);
  check_same(a.metrics, b.metrics);
  check_same(a.pictures, b.pictures);
}

TEST_CASE("reading the request gives the same experiment, wherever in the project it lies") {
  const ExperimentFolder folder;
  folder.file("data/b.png", "");
  folder.file("configs/a.png", "");
  folder.file("configs/scene.json",
              R"({"type": "heightfield", "height": ["a.png", "data:b.png"], "view": {"height": 3}})");
  const std::vector<std::vector<std::string>> experiments = {
      {},
      {R"("question": "\"?\" \u00fc\n")", R"("seed": 9007199254740992)", R"("metrics": [])"},
      {R"("samplers": ["bilinear", {"type": "supersample", "n": [1, 2], "lookup": ["nearest", "bilinear"]}])"},
      {R"("samplers": [{"type": "area", "blur": [0.1, 1e-300, 123456789.123456789, 1e21], "label": "a, \\ b"}])"},
      {R"("scenes": ["heightfield", {"use": "configs/scene.json", "view": {"pitch_deg": [-3, -0.1]}}])"},
      {R"("reference": {"type": "supersample", "n": 64})",
       R"("metrics": ["speed", {"type": "coverage", "against": "pixel"}, "error"])"},
      {R"("reference": {"type": "point", "label": "auto"})"},
      {R"("frames": {"count": 1000000, "still": 999999,
                     "animate": {"view.pitch_deg": [[0, -90], [7, 0.1], [999999, -1e-300]], "view.height": [[3, 5]]}})",
       R"("pictures": ["strip", "plan", {"type": "strip", "column": 63}])"},
  };
  std::filesystem::create_directories(folder.path() / "results/edges");
  for (const auto& lines : experiments) {
    INFO(experiment_with(lines));
    const Experiment experiment = folder.read(experiment_with(lines));
    folder.file("results/edges/experiment.json", experiment.request.dump(2));
    check_same(read_experiment(folder.path() / "results/edges", vocabulary(), {}), experiment);
  }
}

TEST_CASE("the request has every default filled in and every grid spread out") {
  const ExperimentFolder folder;
  folder.file("edges/a.png", "");
  folder.file("data/b.png", "");
  const auto request =
      folder
          .read(experiment_with({R"("scenes": [{"type": "heightfield", "height": ["a.png", "data:b.png"]}])",
                                 R"("samplers": [{"type": "supersample", "n": 2}, "bilinear"])"}))
          .request;
  const std::string a = (folder.path() / "edges/a.png").string();
  CHECK(request.dump(1) == R"({
 "question": "Which is best?",
 "image": {
  "width": 64,
  "height": 48
 },
 "scenes": [
  {
   "type": "heightfield",
   "label": "heightfield[height=a]",
   "height": ")" + a + R"(",
   "generate": "nothing",
   "hierarchy": false,
   "view": {
    "pitch_deg": -20.0,
    "height": 100.0
   },
   "sky": "#80b0ff",
   "credit": ""
  },
  {
   "type": "heightfield",
   "label": "heightfield[height=b]",
   "height": "data:b.png",
   "generate": "nothing",
   "hierarchy": false,
   "view": {
    "pitch_deg": -20.0,
    "height": 100.0
   },
   "sky": "#80b0ff",
   "credit": ""
  }
 ],
 "samplers": [
  {
   "type": "supersample",
   "label": "supersample[n=2]",
   "n": 2,
   "layout": "column",
   "lookup": "nearest"
  },
  {
   "type": "bilinear",
   "label": "bilinear",
   "lookup": "bilinear"
  }
 ],
 "reference": "auto",
 "seed": 1,
 "frames": {
  "count": 1,
  "still": 0,
  "animate": {},
  "move": {}
 },
 "metrics": [
  {
   "type": "error"
  }
 ],
 "pictures": [],
 "keep_images": true
})");
}

}  // namespace
}  // namespace moire::test
