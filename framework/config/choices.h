// The scenes and samplers that an experiment chooses: each entry of its lists, spread out over its grid.
#pragma once

#include <string>
#include <vector>

#include "config/experiment.h"
#include "config/experiment_format.h"
#include "config/settings_reader.h"

namespace moire {

// One scene or contender, while it is checked.
struct Choice {
  Place place;       // of the entry it comes from
  std::string path;  // "samplers[2]"
  const Plugin* plugin = nullptr;
  std::vector<Parameter> table;  // of the plugin; a sampler's goes on with its options
  Cells cells;
  std::string label;        // empty: none
  std::string name;         // given by name_choices
  bool if_it_fits = false;  // of a sampler
};

// Whether a row is one of the plugin's own, a choice of lookup or filter, or of the lookup or filter chosen.
bool has_effect(const Choice& choice, std::size_t row);

// What entries are read with.
struct ChoiceContext {
  const Vocabulary& vocabulary;
  const format::OptionNames& options;
  const Reading& reading;
};

// One choice for each combination of the entry's settings; none after adding problems.
std::vector<Choice> read_entry(const JsonNode& entry, const std::string& path, Kind kind, bool takes_grids,
                               const ChoiceContext& context);

// Whether a sampler's entry is to be left out where its plugin is missing, and it is.
bool is_left_out(const JsonNode& entry, const std::string& path, const ChoiceContext& context);

// Finds `type` of an entry ("a sampler is a name or ..."); null after adding a problem.
const JsonNode* entry_type(const JsonNode& entry, const std::string& path, std::string_view noun, Problems& problems);

SceneChoice scene_of(const Choice& choice);
SamplerChoice sampler_of(const Choice& choice);

// The entry that makes just this choice.
nlohmann::ordered_json written(const Choice& choice);

}  // namespace moire
