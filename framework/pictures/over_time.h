// Pictures that show all frames of an animation side by side, a column of the picture for each.
#pragma once

#include <string>

namespace moire {

// Why there can be no such picture of so many frames; empty: there can.
std::string over_time_problem(int frames);

}  // namespace moire
