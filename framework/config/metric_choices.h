// The metric passes that an experiment chooses.
#pragma once

#include <vector>

#include "config/experiment.h"
#include "config/settings_reader.h"

namespace moire {

struct MetricEntry {
  Place place;
  std::string path;  // "metrics[2]"
  MetricChoice choice;
  nlohmann::ordered_json written;  // the entry that makes just this choice
};

// `list` null: the default, said to stand at `root`. Problems: all that is wrong with the entries, and a pass that is
// there twice.
std::vector<MetricEntry> read_metrics(const JsonNode* list, const Place& root, const Vocabulary& vocabulary,
                                      const Reading& reading);

}  // namespace moire
