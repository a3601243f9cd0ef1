// What contenders are judged against, and why it can be trusted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/exact_settings.h"
#include "metrics/merged.h"
#include "metrics/metric.h"
#include "run/contender.h"

namespace moire {

// How a reference is made: a sampler, and a weaker form of it to judge it by.
struct ReferenceChoice {
  SamplerChoice sampler;
  std::optional<SamplerChoice> half;  // half as many lines or points; none: nothing is known of its error
  bool is_exact = false;
};

// The best that any sampler offers for a scene with these answers. Error: none offers anything.
ReferenceChoice best_reference(const Catalog& catalog, Questions answered);

// The sampler that an experiment names: trusted as far as it offers itself, with just these settings, for a scene with
// these answers.
ReferenceChoice named_reference(const SamplerChoice& named, Questions answered);

// What judges a scene's contenders: their colours the exact frame's, their fragments those of the frame that they see
// themselves, which may answer less.
struct References {
  ReferenceChoice colors, fragments;
};

// `named`: by the experiment; none, and for fragments where the contenders' frame does not answer what it asks: the
// best. Error: there is none.
References choose_references(const std::optional<SamplerChoice>& named, const Catalog& catalog,
                             const SceneChoice& scene);

// All that a reference depends on, beside the program.
struct ReferenceRequest {
  ReferenceChoice choice;
  SceneChoice scene;    // with the exact settings of the frame
  std::string changes;  // "walk=grid, levels=none": of these, what the experiment has otherwise
  ImageSize image;
  int frame_number = 0;
  std::uint64_t seed = 0;
};

struct Reference {
  std::string recipe;  // "area[lines=32,layout=radial]; walk=grid, levels=none"
  Picture picture;
  double error = 0;    // rmse in levels, linear light; NaN: unknown
  std::string how;     // how `error` was got
  std::string origin;  // "computed now"
};

// Pictures are floats: values below 1 are off by half of 2^-24 at most, the reference's and an equally exact
// contender's, so that no pixel of the two differs by more than 2^-24 of full scale (what both round agrees far
// better). In levels; a bound of every pixel's error, and so of the rmse.
inline constexpr double exact_error = levels_of_full_scale * 0x1p-24;

// "area[lines=32,layout=radial]; walk=grid, levels=none".
std::string recipe_of(const ReferenceRequest& request);

// `frame`: the scene's with the settings of the request.
Reference make_reference(const ReferenceRequest& request, const Frame& frame, const Workers& workers);

// Why it can be trusted, in a few words: "exact, no sampling error".
std::string trust_in(const Reference& reference, const ReferenceChoice& choice);

// The exact fragments that coverage is held against, block by block.
std::vector<MergedBlock> exact_fragments(Against against, const ReferenceChoice& choice, const Frame& frame,
                                         int frame_number, std::uint64_t seed, const Workers& workers);

}  // namespace moire
