// A record without the plugin.
#include <moire/plugin.h>

extern "C" __attribute__((visibility("default"))) const moire::Record moire_record;
constexpr moire::Record moire_record = moire::make_record(moire::Kind::sampler, "no_plugin", "1.0.0");
