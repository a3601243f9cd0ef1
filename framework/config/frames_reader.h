// Reads "frames": {"count": 400, "animate": {"view.x": [[0, 0.0], [399, 199.5]]}}; "move" instead of "animate" adds to
// every scene's own value.
#pragma once

#include <vector>

#include "config/choices.h"
#include "config/frames.h"

namespace moire {

// `node` null: one frame. Problems: all that is wrong, also with parameters that one of `scenes` lacks.
Frames read_frames(const JsonNode* node, const std::vector<Choice>& scenes, const Reading& reading);

// The object that gives these frames.
nlohmann::ordered_json written(const Frames& frames);

}  // namespace moire
