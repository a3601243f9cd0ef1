// Adaptive supersampling: more points where the first ones differ. What those miss stays missed.
#include <bit>

#include <moire/plugin.h>
#include <moire/reseed.h>

#include "corners.h"
#include "two_level.h"

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    choice("method", "corners", "corners two_level",
           "cells whose corners differ are cut into four, or pixels whose few points differ get many"),
    integer("depth", 4, 0, 6, "halvings", "of corners: smallest cells are a pixel halved as often each way"),
    choice("first", "1", "1 2 4",
           "of corners: cells along a pixel's side that all pixels have; what is smaller than they are can be missed, "
           "however deep"),
    integer("coarse", 2, 1, 16, "points", "of two_level: along a pixel's side, jittered, in all pixels"),
    integer("fine", 8, 1, 64, "points",
            "of two_level: along a pixel's side, jittered, in their place where they differ"),
    flag("neighbours", true, "of two_level: pixels are refined too where one of the eight around them is"),
    adaptive::Criterion::parameters[0],
    adaptive::Criterion::parameters[1],
    moire::Reseed::parameter,
};

class Adaptive final : public moire::Sampler {
 public:
  explicit Adaptive(const moire::Settings& settings) : settings_(settings) {}

  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    const adaptive::Criterion criterion(settings_, request.frame.blend());
    const auto integer = [&](std::string_view name) { return static_cast<int>(settings_.integer(name)); };
    if (settings_.text("method") == "corners") {
      const int first = std::countr_zero(static_cast<unsigned>(settings_.text("first").front() - '0'));
      return std::make_unique<adaptive::Corners>(request, criterion,
                                                 adaptive::Corners::Lattices{first, integer("depth")});
    }
    return std::make_unique<adaptive::TwoLevel>(
        request, criterion, adaptive::TwoLevel::Grids{integer("coarse"), integer("fine"), settings_.flag("neighbours")},
        moire::Reseed(settings_));
  }

 private:
  moire::Settings settings_;
};

}  // namespace

MOIRE_SAMPLER(adaptive, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "More points where the first ones differ; what those miss stays missed.",
                  .source = "Whitted 1980, doi:10.1145/358876.358882: corners; Cook 1986, doi:10.1145/7529.8927, and "
                            "Maddock, section 7.1: two levels",
                  .parameters = parameters,
                  .claims = {.deterministic = false},
                  .make = [](const moire::Settings& settings) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<Adaptive>(settings);
                  },
              }))
