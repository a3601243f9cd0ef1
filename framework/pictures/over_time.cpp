#include "pictures/over_time.h"

#include <fmt/format.h>

namespace moire {

namespace {

constexpr int most_frames = 16384;  // as wide as an image may be

}  // namespace

std::string over_time_problem(int frames) {
  if (frames < 2) return "shows frames side by side; give \"frames\" a \"count\" of 2 or more";
  if (frames > most_frames) {
    return fmt::format("shows frames side by side, and there are {}; give \"frames\" a \"count\" of {} or less", frames,
                       most_frames);
  }
  return {};
}

}  // namespace moire
