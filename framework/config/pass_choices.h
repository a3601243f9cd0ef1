// The passes that an experiment chooses: metrics and pictures.
#pragma once

#include <vector>

#include "config/experiment.h"
#include "config/settings_reader.h"

namespace moire {

struct PassEntry {
  Place place;
  std::string path;  // "metrics[2]"
  const PassDescription* description;
  PassChoice choice;
  nlohmann::ordered_json written;  // the entry that makes just this choice
};

// Where passes are chosen.
struct PassList {
  std::string_view key;   // "metrics"
  std::string_view noun;  // "metric"
  std::span<const PassDescription* const> known;
  std::string_view unless_given = "";  // the pass taken where there is no list; empty: none
  bool once = false;                   // a pass may be there only once
};

// `list` null: the default, said to stand at `root`. Problems: all that is wrong with the entries.
std::vector<PassEntry> read_passes(const JsonNode* list, const Place& root, const PassList& passes,
                                   const Reading& reading);

}  // namespace moire
