// An experiment that runs in a tenth of a second.
#pragma once

#include <string>
#include <string_view>

namespace moire::test {

// A terrain of 64 x 64 voxels in 24 x 16 pixels.
inline std::string tiny_experiment(
    std::string_view samplers = R"(["point", {"type": "supersample", "n": 2}])",
    std::string_view metrics = R"(["error", "coverage"])",
    std::string_view scenes = R"([{"type": "heightfield", "label": "hills", "size": 64}])") {
  std::string json = "{\n\"question\": \"Does it run?\",\n\"image\": {\"width\": 24, \"height\": 16},\n\"scenes\": ";
  json += scenes;
  json += ",\n\"samplers\": ";
  json += samplers;
  json += ",\n\"metrics\": ";
  json += metrics;
  return json += "\n}\n";
}

}  // namespace moire::test
