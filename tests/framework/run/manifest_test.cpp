// Job keys: what they must never do is stay the same when a result would be another.
#include "run/manifest.h"

#include <catch2/catch_test_macros.hpp>
#include <set>

#include "framework/run/keyed_plugins.h"
#include "message_of.h"
#include "metrics/registry.h"
#include "pictures/registry.h"
#include "temporary_folder.h"

namespace moire::test {

namespace {

using namespace parameter;
namespace fs = std::filesystem;

// A job whose parts a test may change one by one.
struct Job {
  TemporaryFolder folder;
  Plugin scene_file = scene_in(folder);
  Plugin sampler_file = sampler_in(folder, "dots");
  Plugin reference_file = sampler_in(folder, "truth");
  SceneChoice scene{"hills", &scene_file, Settings(scene_parameters)};
  SamplerChoice sampler{"dots", &sampler_file, Settings(sampler_parameters), "nearest"};
  SamplerChoice reference{"truth", &reference_file, Settings(sampler_parameters), "nearest"}, fragments = reference;
  Experiment experiment;

  Job() {
    folder.file("a.png", "heights");
    scene.settings.set("height", (folder.path() / "a.png").string());
    experiment.image = {40, 30};
    experiment.metrics = {{"error", Settings(error_description.parameters)},
                          {"speed", Settings(speed_description.parameters)}};
  }
  std::string key() const {
    ContentHashes hashes;
    return job_key(experiment, scene, sampler, {{reference, {}, false}, {fragments, {}, false}}, hashes);
  }
};

}  // namespace

TEST_CASE("a job has the same key wherever its files lie and whatever things are called") {
  const Job job;
  Job other;
  fs::rename(other.folder.path() / "a.png", other.folder.path() / "b.png");
  other.scene.settings.set("height", (other.folder.path() / "b.png").string());
  other.scene.name = "a label";
  other.sampler.name = "another label";
  other.experiment.name = "elsewhere";
  other.experiment.question = "Why not?";
  CHECK(other.key() == job.key());
}

TEST_CASE("other contenders, and how timing is done, do not change the key of a job") {
  const Job job;
  Job other;
  other.experiment.samplers = {other.sampler, other.reference};
  other.experiment.metrics[1].settings.set("rounds", std::int64_t{99});
  CHECK(other.key() == job.key());
  other.experiment.metrics.pop_back();
  CHECK(other.key() == job.key());
}

TEST_CASE("whatever changes a result changes the key") {
  std::set<std::string> keys{Job().key()};
  const auto changed = [&](auto change) {
    Job job;
    change(job);
    return keys.insert(job.key()).second;
  };
  CHECK(changed([](Job& j) { j.experiment.image.width = 41; }));
  CHECK(changed([](Job& j) { j.experiment.image.height = 31; }));
  CHECK(changed([](Job& j) { j.experiment.seed = 2; }));
  CHECK(changed([](Job& j) { j.experiment.metrics[0].settings.set("bad_above", 9.0); }));
  CHECK(changed([](Job& j) { j.experiment.metrics.erase(j.experiment.metrics.begin()); }));
  CHECK(changed([](Job& j) { j.experiment.metrics.push_back({"flicker", Settings(flicker_description.parameters)}); }));
  CHECK(changed([](Job& j) { j.experiment.frames.count = 2; }));
  CHECK(changed([](Job& j) {
    j.experiment.frames.count = 2;
    j.experiment.frames.still = 1;
  }));
  CHECK(changed([](Job& j) { j.experiment.frames.tracks = {{"far", {{0, 10}}}}; }));
  CHECK(changed([](Job& j) { j.experiment.frames.tracks = {{"far", {{0, 11}}}}; }));
  CHECK(changed([](Job& j) { j.experiment.frames.tracks = {{"near", {{0, 10}}}}; }));
  CHECK(changed([](Job& j) { j.experiment.pictures = {{"footprint", Settings(footprint_description.parameters)}}; }));
  CHECK(changed([](Job& j) {
    j.experiment.pictures = {{"footprint", Settings(footprint_description.parameters)}};
    j.experiment.pictures[0].settings.set("in", std::string("image"));
  }));
  CHECK(changed([](Job& j) { j.scene.settings.set("far", 11.0); }));
  CHECK(changed([](Job& j) { j.scene.settings.set("height", std::string()); }));
  CHECK(changed([](Job& j) { j.sampler.settings.set("n", std::int64_t{5}); }));
  CHECK(changed([](Job& j) { j.sampler.lookup = "bilinear"; }));
  CHECK(changed([](Job& j) { j.reference.settings.set("n", std::int64_t{5}); }));
  CHECK(changed([](Job& j) { j.reference.lookup = "bilinear"; }));
  CHECK(changed([](Job& j) { j.fragments.settings.set("n", std::int64_t{5}); }));
  CHECK(changed([](Job& j) { j.folder.file("a.png", "other heights"); }));
  CHECK(changed([](Job& j) { j.folder.file("hills.so", "hills 2"); }));
  CHECK(changed([](Job& j) { j.folder.file("dots.so", "dots 2"); }));
  CHECK(changed([](Job& j) { j.folder.file("truth.so", "truth 2"); }));
}

TEST_CASE("a job whose data cannot be read has no key") {
  Job job;
  const fs::path missing = job.folder.path() / "missing.png";
  job.scene.settings.set("height", missing.string());
  CHECK(message_of([&] { job.key(); }) == missing.string() + ": cannot be read");
}

TEST_CASE("a manifest names program, plugins and data with their hashes, each once") {
  Job job;
  job.experiment.scenes = {job.scene, job.scene};
  job.experiment.samplers = {job.sampler};
  job.experiment.seed = 7;
  ContentHashes hashes;
  const std::vector<std::string> command{"moire", "run", "x"};
  const auto manifest = make_manifest(job.experiment, command, 3, hashes);
  CHECK(manifest.at("program").at("version") == MOIRE_VERSION);
  CHECK(manifest.at("program").at("interface") == interface_version);
  CHECK(manifest.at("command") == nlohmann::ordered_json(command));
  CHECK(manifest.at("threads") == 3);
  CHECK(manifest.at("seed") == 7);
  CHECK(manifest.at("plugins").size() == 2);
  CHECK(manifest.at("plugins").at("hills").at("hash") == hashes.of(job.folder.path() / "hills.so"));
  CHECK(manifest.at("plugins").at("dots").at("version") == "1");
  REQUIRE(manifest.at("data").size() == 1);
  CHECK(manifest.at("data").begin().value() == hashes.of(job.folder.path() / "a.png"));
}

}  // namespace moire::test
