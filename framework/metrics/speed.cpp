// Render time: measured by the runner, for all contenders of a scene in turn.
#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    integer("rounds", 7, 1, 1000, "rounds", "times each contender renders the frame on one thread, after a warm-up"),
    real("at_most", 20, 0, 1e5, "seconds", "no further round on one thread begins after so long, for a scene"),
    flag("reference", true, "the reference is timed too: once on one thread and once on all"),
};

constexpr Quantity quantities[] = {
    {.name = "speed.ms_per_frame",
     .unit = "ms",
     .meaning =
         "median over rounds of the time to render one frame on one thread, begin() included, images, metrics and "
         "files not; low and high: the rounds' quartiles",
     .is_main = true},
    {.name = "speed.ms_per_next_frame",
     .unit = "ms",
     .meaning =
         "the same, on one thread, where the rendering of the frame before is there to continue from and the geometry "
         "has stayed as it was; only of contenders that continue",
     .is_main = true},
    {.name = "speed.ms_per_frame_all_threads", .unit = "ms", .meaning = "the same on all threads of the run"},
    {.name = "speed.queries_per_pixel", .unit = "per pixel", .meaning = "points traced, or stretches of lines"},
    {.name = "speed.steps_per_pixel",
     .unit = "per pixel",
     .meaning = "elements stepped over after a batch's first hit"},
};

}  // namespace

const PassDescription speed_description{
    .name = "speed",
    .summary = "Render time of one frame, all contenders interleaved in one process.",
    .source = "",
    .parameters = parameters,
    .quantities = quantities,
};

}  // namespace moire
