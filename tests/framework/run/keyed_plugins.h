// Plugins of which only files and tables matter: for tests of keys.
#pragma once

#include <string>

#include "loading/catalog.h"
#include "temporary_folder.h"

namespace moire::test {

inline constexpr Parameter scene_parameters[] = {parameter::file("height", "heights"),
                                                 parameter::real("far", 10, 0, 100, "", "distance")};
inline constexpr Parameter sampler_parameters[] = {parameter::integer("n", 4, 1, 256, "points", "points")};
inline constexpr ScenePlugin keyed_scene{.summary = "", .source = "", .parameters = scene_parameters};
inline constexpr SamplerPlugin keyed_sampler{.summary = "", .source = "", .parameters = sampler_parameters};

// "hills", in the file hills.so.
inline Plugin scene_in(const TemporaryFolder& folder) {
  return {.file = folder.file("hills.so", "hills 1"),
          .kind = Kind::scene,
          .name = "hills",
          .version = "1",
          .scene = &keyed_scene};
}
// In the file `name`.so.
inline Plugin sampler_in(const TemporaryFolder& folder, const std::string& name) {
  return {.file = folder.file(name + ".so", name + " 1"),
          .kind = Kind::sampler,
          .name = name,
          .version = "1",
          .sampler = &keyed_sampler};
}

}  // namespace moire::test
