// A sampler that throws what nobody expects.
#include <moire/plugin.h>

namespace {

class Throws final : public moire::Sampler {
 public:
  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest&) const override { throw 42; }
};

}  // namespace

MOIRE_SAMPLER(throws_in_begin, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Throws a number when it begins.",
                  .source = "",
                  .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<Throws>();
                  },
              }))
