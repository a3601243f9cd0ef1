#include "run/contender.h"

#include "sampling/filters.h"
#include "sampling/lookups.h"
#include "sampling/pattern_sampler.h"

namespace moire {

Contender::Contender(const SamplerChoice& choice)
    : name_(choice.name),
      continues_(choice.plugin->sampler->continues(choice.settings)),
      sampler_(make_sampler(*choice.plugin->sampler, choice.settings, {choice.filter, choice.options})),
      lookup_(make_lookup(choice.lookup, choice.options)),
      filter_(make_filter(choice.filter, choice.options, 1)) {}

Picture render_picture(const Contender& contender, const Frame& frame, int frame_number, std::uint64_t seed,
                       const Workers& workers, double* error_bound) {
  const ImageSize size = frame.size();
  Picture picture{size,
                  std::vector<Color>(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height))};
  const auto rendering = contender.begin(frame, seed, frame_number);
  workers.render_runs(*rendering, frame, false, [&](std::size_t, const PixelBlock& block) { put(block, picture); });
  if (error_bound) *error_bound = rendering->error_bound();
  return picture;
}

}  // namespace moire
