// The commands: each prints its answer on stdout and returns the exit code. Error: the request is wrong.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/session.h"

namespace moire::app {

// Exit codes. `failed`: what could only be found out while running.
inline constexpr int done = 0, failed = 1, wrong_request = 2;

// Does the work itself, after the request was found to be right: what it throws is printed and means `failed`.
int attempt(const std::function<int()>& work);

struct RunOptions {
  std::filesystem::path experiment;
  std::filesystem::path output;  // empty: results/<name of the experiment>
  int threads = 0;
  bool fresh_references = false;  // none of an earlier run is used
  Overrides overrides;
  std::vector<std::string> command;  // as given, for the manifest
};
int run(const Session& session, const RunOptions& options);

int check(const Session& session, const std::filesystem::path& experiment, const Overrides& overrides);

// `what`: samplers, scenes, metrics, pictures, lookups, or empty for all.
int list(const Session& session, const std::string& what, bool as_json);

// Sampler, scene, metric or lookup.
int describe(const Session& session, const std::string& name, bool as_json);

int schema(const Session& session);

struct RenderOptions {
  std::string scene, sampler;  // a name, or a JSON file of configs/
  std::filesystem::path output = "picture.png";
  int width = 640, height = 480;
  int threads = 0;
  std::vector<std::string> sets;  // "scene.view.pitch_deg=-10", "sampler.n=4"
};
int render(const Session& session, const RenderOptions& options);

int report(const std::vector<std::filesystem::path>& folders);

// A folder with the smallest plugin of this name.
int new_plugin(const std::string& kind, const std::string& name, const std::filesystem::path& folder);

}  // namespace moire::app
