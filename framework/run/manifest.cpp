#include "run/manifest.h"

#include <ctime>
#include <fstream>
#include <map>

#include <sys/utsname.h>

#include <fmt/format.h>

#include "config/frames_reader.h"
#include "metrics/registry.h"
#include "run/hash.h"

namespace moire {

namespace {

// Metrics and pictures; timing is no part of a job.
nlohmann::ordered_json passes_of(const Experiment& experiment) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto* passes : {&experiment.metrics, &experiment.pictures}) {
    for (const PassChoice& pass : *passes) {
      const bool is_timing = passes == &experiment.metrics && registered_metric(pass.name).is_timing();
      if (!is_timing) json.push_back({pass.name, json_of(pass.settings)});
    }
  }
  return json;
}

std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

}  // namespace

std::string job_key(const Experiment& experiment, const SceneChoice& scene, const SamplerChoice& sampler,
                    const References& references, ContentHashes& hashes) {
  const nlohmann::ordered_json all{
      {"program", hashes.of_program()},
      {"image", {experiment.image.width, experiment.image.height}},
      {"scene", content_of(scene, hashes)},
      {"sampler", content_of(sampler, hashes)},
      {"reference", content_of(references.colors.sampler, hashes)},
      {"fragments", content_of(references.fragments.sampler, hashes)},
      {"frames", written(experiment.frames)},
      {"passes", passes_of(experiment)},
      {"seed", experiment.seed},
  };
  return hash_of(all.dump());
}

nlohmann::ordered_json make_manifest(const Experiment& experiment, std::span<const std::string> command, int threads,
                                     ContentHashes& hashes) {
  utsname system{};
  uname(&system);
  nlohmann::ordered_json manifest{
      {"program", {{"version", MOIRE_VERSION}, {"hash", hashes.of_program()}, {"interface", interface_version}}},
      {"compiler", fmt::format("{} {}", MOIRE_COMPILER, MOIRE_COMPILER_FLAGS)},
      {"build", MOIRE_BUILD_TYPE},
      {"command", command},
      {"date", date()},
      {"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
      {"processor", processor()},
      {"threads", threads},
      {"seed", experiment.seed},
  };
  if (!experiment.left_out.empty()) manifest["left_out"] = experiment.left_out;
  std::map<std::string, const Plugin*> plugins;
  for (const SceneChoice& scene : experiment.scenes) plugins[scene.plugin->name] = scene.plugin;
  for (const SamplerChoice& sampler : experiment.samplers) plugins[sampler.plugin->name] = sampler.plugin;
  for (const auto& [name, plugin] : plugins) {
    manifest["plugins"][name] = {{"version", plugin->version}, {"hash", hashes.of(plugin->file)}};
  }
  for (const SceneChoice& scene : experiment.scenes) {
    for (const auto& file : data_files(scene))
      manifest["data"][(file.parent_path().filename() / file.filename()).string()] = hashes.of(file);
  }
  return manifest;
}

}  // namespace moire
