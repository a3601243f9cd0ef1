// A sampler that lets a canvas paint and copies its pixels. What element they show, it cannot say.
#pragma once

#include <memory>

#include <moire/sampler.h>

#include "canvas.h"
#include "painted_layers.h"

namespace outside {

class Painter final : public moire::Sampler {
 public:
  using MakeCanvas = std::unique_ptr<Canvas> (*)(const Painting& painting);
  explicit Painter(MakeCanvas make) : make_(make) {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    auto canvas = make_(painting_of(request.frame));
    canvas->draw();
    return std::make_unique<Painted>(std::move(canvas), request.frame.blend());
  }

 private:
  class Painted final : public moire::Rendering {
   public:
    Painted(std::unique_ptr<Canvas> canvas, moire::Blend blend) : canvas_(std::move(canvas)), blend_(blend) {}

    void render(moire::PixelBlock& block) const override {
      for (int y = block.y0; y < block.y0 + block.height; ++y) {
        for (int x = block.x0; x < block.x0 + block.width; ++x)
          block.add(block.slot(x, y), moire::background, 1, of_codes(canvas_->codes(x, y), blend_));
      }
      block.counters.queries += static_cast<std::uint64_t>(block.width) * static_cast<std::uint64_t>(block.height);
    }
    moire::Blocks blocks() const override { return moire::Blocks::rows; }

   private:
    std::unique_ptr<Canvas> canvas_;
    moire::Blend blend_;
  };

  MakeCanvas make_;
};

}  // namespace outside
