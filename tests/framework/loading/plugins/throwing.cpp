// Throws while it is opened.
#include <stdexcept>

#include <moire/plugin.h>

namespace {

struct Throwing {
  Throwing() { throw std::runtime_error("no table for this machine"); }
};
const Throwing throwing;

}  // namespace

MOIRE_SAMPLER(throwing, "1.0.0", (moire::SamplerPlugin{.summary = "Throws while it is opened.", .source = "None"}))
