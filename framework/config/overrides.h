// Changes from the command line: `--set samplers[1].n=8`.
#pragma once

#include <span>
#include <string>

#include "json/json_tree.h"

namespace moire {

// Writes each PATH=VALUE into the tree, in order. VALUE is JSON, or else a text. What is written is not checked here:
// it stands in the tree with `--set PATH=VALUE` as its source. A path through something that is no object or list, or
// to an item that a list lacks, is a problem; members that are missing are made.
void apply_sets(std::span<const std::string> sets, JsonNode& root, Problems& problems);

}  // namespace moire
