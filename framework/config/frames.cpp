#include "config/frames.h"

#include <algorithm>

namespace moire {

double Track::at(int frame) const {
  const auto next = std::find_if(keys.begin(), keys.end(), [&](const Keyframe& key) { return key.frame > frame; });
  if (next == keys.begin()) return keys.front().value;
  if (next == keys.end()) return keys.back().value;
  const Keyframe &a = *(next - 1), &b = *next;
  return a.value + (b.value - a.value) * (frame - a.frame) / (b.frame - a.frame);
}

Settings settings_at(Settings scene, const Frames& frames, int frame) {
  for (const Track& track : frames.tracks) {
    const double own = track.is_added ? scene.real(track.parameter) : 0;
    scene.set(track.parameter, own + track.at(frame));
  }
  return scene;
}

}  // namespace moire
