// The frames of an experiment, and how scene parameters move over them.
#pragma once

#include <string>
#include <vector>

#include <moire/settings.h>

namespace moire {

struct Keyframe {
  int frame;
  double value;
};

// One parameter over time: straight between its keyframes, constant before the first and after the last.
struct Track {
  std::string parameter;       // "view.x"
  std::vector<Keyframe> keys;  // one at least, frames rising
  bool is_added = false;       // to the scene's own value; else it stands in its place

  double at(int frame) const;
};

struct Frames {
  int count = 1;
  int still = 0;  // the frame that images, error, coverage and speed are of
  std::vector<Track> tracks;
};

// A scene's settings at a frame. Requires: the tracks' parameters are numbers of the scene.
Settings settings_at(Settings scene, const Frames& frames, int frame);

}  // namespace moire
