// Uses a function that no library has.
#include <moire/plugin.h>

extern "C" void moire_test_function_of_no_library();

MOIRE_SAMPLER(missing_symbol, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Uses a function that no library has.",
                  .source = "None",
                  .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
                    moire_test_function_of_no_library();
                    return nullptr;
                  },
              }))
