// A sampler, a lookup and a filter, ready to render.
#pragma once

#include <memory>
#include <string>

#include "config/experiment.h"
#include "metrics/picture.h"
#include "run/workers.h"

namespace moire {

class Contender {
 public:
  // Error or any exception of the plugin's.
  explicit Contender(const SamplerChoice& choice);
  // A sampler without a plugin, of the host's own.
  Contender(std::string name, std::unique_ptr<Sampler> sampler, bool continues = false)
      : name_(std::move(name)), continues_(continues), sampler_(std::move(sampler)) {}

  const std::string& name() const { return name_; }
  // Whether it saves time by a previous rendering.
  bool continues() const { return continues_; }
  std::unique_ptr<Rendering> begin(const Frame& frame, std::uint64_t seed, int frame_number = 0,
                                   const Rendering* previous = nullptr) const {
    return sampler_->begin({.frame = frame,
                            .lookup = lookup_.get(),
                            .filter = filter_.get(),
                            .seed = seed,
                            .frame_number = frame_number,
                            .previous = previous});
  }

 private:
  std::string name_;
  bool continues_;
  std::unique_ptr<Sampler> sampler_;
  std::unique_ptr<Lookup> lookup_;
  std::unique_ptr<Filter> filter_;  // null: the box
};

// `error_bound`: set to the rendering's, unless null.
Picture render_picture(const Contender& contender, const Frame& frame, int frame_number, std::uint64_t seed,
                       const Workers& workers, double* error_bound = nullptr);

}  // namespace moire
