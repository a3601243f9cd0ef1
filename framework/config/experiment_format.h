// What an experiment file holds beside plugins and metrics; for the reader and for the schema.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <moire/settings.h>

#include "config/experiment.h"

namespace moire::format {

inline constexpr Parameter question =
    parameter::text("question", "", "what the experiment shall find out, in a sentence");
inline constexpr Parameter image[] = {
    parameter::integer("width", 400, 1, 16384, "pixels", "columns of the image"),
    parameter::integer("height", 400, 1, 16384, "pixels", "rows of the image"),
};
// Every integer up to 2^53 is the same number in all programs that read JSON.
inline constexpr Parameter seed =
    parameter::integer("seed", 1, 0, std::int64_t{1} << 53, "", "chooses the random numbers of the whole experiment");

inline constexpr Parameter keep_images =
    parameter::flag("keep_images", true, "images are kept and shown; false: only judged, for sweeps over many scenes");
inline constexpr Parameter if_installed = parameter::flag(
    "if_installed", false, "true: where there is no plugin of this type, the entry is left out instead of refused");
inline constexpr Parameter if_it_fits = parameter::flag(
    "if_it_fits", false, "true: on scenes that do not answer what it asks, the sampler is left out instead of refused");
inline constexpr Parameter frame_count =
    parameter::integer("count", 1, 1, 1'000'000, "frames", "frames of the animation; 1: a still image");
inline constexpr Parameter still_frame =
    parameter::integer("still", 0, 0, 999'999, "", "the frame that images, error, coverage and speed are of, from 0");
inline constexpr std::string_view animate_key = "animate", move_key = "move";

inline constexpr std::string_view keys[] = {"question", "image",  "scenes",  "samplers", "reference",
                                            "seed",     "frames", "metrics", "pictures", "keep_images"};
inline constexpr std::string_view default_reference = "auto";
inline constexpr std::string_view default_metric = "error";

// The names of lookups and filters as the choices of a parameter: "nearest bilinear".
struct OptionNames {
  explicit OptionNames(const Vocabulary& vocabulary);
  std::string lookups, filters;
};

// The parameters of a plugin; those of a sampler go on with its options, which can be given and be a grid like any
// other: the lookup, the filter if it takes one, and what all of these take. Requires: `names` outlives the table.
std::vector<Parameter> parameters_of(const Plugin& plugin, const Vocabulary& vocabulary, const OptionNames& names);

inline constexpr std::string_view lookup_key = "lookup", filter_key = "filter";

// Whether a filter can be chosen for such samplers.
bool takes_filters(const SamplerPlugin& sampler);

// The words of "column grid".
std::vector<std::string_view> words(std::string_view choices);

}  // namespace moire::format
