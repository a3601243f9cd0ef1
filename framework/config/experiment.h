// An experiment as the program sees it: read from JSON, checked, every default filled in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "config/frames.h"
#include "loading/catalog.h"
#include "metrics/description.h"

namespace moire {

struct SceneChoice {
  std::string name;  // its label, or made by name_choices
  const Plugin* plugin = nullptr;
  Settings settings;                                // complete; files are paths that exist
  std::map<std::string, std::string> without = {};  // samplers that do not fit, and what they miss here
};

// A sampler with its settings, lookup and filter: a contender.
struct SamplerChoice {
  std::string name;  // "supersample[n=4]"
  const Plugin* plugin = nullptr;
  Settings settings;
  std::string lookup;          // a name from Vocabulary::lookups
  std::string filter = "box";  // a name from Vocabulary::filters
  Settings options = {};       // of that lookup and that filter; what is not there has its default
};

// A metric or a picture.
struct PassChoice {
  std::string name;  // "coverage"
  Settings settings;
};

struct Experiment {
  std::string name;  // of its folder
  std::string question;
  ImageSize image;
  std::vector<SceneChoice> scenes;
  std::vector<SamplerChoice> samplers;
  std::optional<SamplerChoice> reference;  // none: the best that each scene allows ("auto")
  std::uint64_t seed = 1;
  Frames frames;
  std::vector<PassChoice> metrics, pictures;
  bool keep_images = true;            // else images are only judged
  std::vector<std::string> left_out;  // entries with if_installed whose plugins are not there: a sentence each
  // With every default filled in and every grid spread out; reading it gives this experiment again.
  nlohmann::ordered_json request;
};

// A name an experiment may use, and what it is.
struct NamedSummary {
  std::string_view name, summary;
  std::span<const Parameter> parameters = {};  // all in the group of this name: "mipmap.bias"
};

// What an experiment may speak of.
struct Vocabulary {
  const Catalog* catalog = nullptr;
  std::span<const PassDescription* const> metrics;
  // The first, "nearest", asks scenes for nothing; all others for Questions::surface.
  std::span<const NamedSummary> lookups;
  std::span<const PassDescription* const> pictures = {};
  // The first, "box", is what samplers do by themselves.
  std::span<const NamedSummary> filters = {};
};

// Command-line changes to an experiment.
struct Overrides {
  std::vector<std::string> sets;  // "image.width=64", "samplers[1].n=8"
  std::string only;               // "SCENE/SAMPLER", either may be empty
};

// Reads and checks the whole file. `path` is the JSON file or a folder with an experiment.json. Error: everything that
// is wrong, one line each: `file:line: path: what is wrong (found); what would be right`.
Experiment read_experiment(const std::filesystem::path& path, const Vocabulary& vocabulary, const Overrides& overrides);

// What this sampler asks for and this scene does not have; empty where it can run.
std::string missing_for(const SceneChoice& scene, const SamplerChoice& sampler, const Vocabulary& vocabulary);
// Why this sampler cannot run on this scene; empty where it can.
std::string mismatch(const SceneChoice& scene, const SamplerChoice& sampler, const Vocabulary& vocabulary);
// Why this pass cannot be run over this scene; empty where it can.
std::string mismatch(const SceneChoice& scene, const PassDescription& pass, const Settings& settings,
                     const Vocabulary& vocabulary);

// The experiment file format as JSON Schema (draft 7), for editors.
nlohmann::ordered_json experiment_schema(const Vocabulary& vocabulary);

}  // namespace moire
