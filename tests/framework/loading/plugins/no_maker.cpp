// A sampler that forgot to say how it is made.
#include <moire/plugin.h>

MOIRE_SAMPLER(no_maker, "1.0.0", (moire::SamplerPlugin{.summary = "Cannot be made.", .source = "None"}))
