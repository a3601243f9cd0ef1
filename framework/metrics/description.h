// What a pass over the images (a metric, a picture) says of itself: read by the experiment reader, by `moire list` and
// by every report.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <moire/plugin.h>

namespace moire {

// One number that a pass reports, named `pass.quantity`.
struct Quantity {
  std::string_view name;     // "error.rmse"
  std::string_view unit;     // "levels", "ms", "" for ratios
  std::string_view meaning;  // formula and colour space, in one sentence
  bool lower_is_better = true;
  bool is_judged = true;  // false: describes (a count of elements, say), neither end is better; no report marks a best
  bool is_main = false;   // among the few numbers that a summary shows; where none is, the pass's first
};

// A chart that a pass draws, a line for each contender; both axes are logarithmic.
struct CurveDescription {
  std::string_view name;  // "spectrum.error_power"
  std::string_view title, x_axis, y_axis;
};

// What a pass is run over.
struct Extent {
  ImageSize image;
  int frames;
};

struct PassDescription {
  std::string_view name;     // "error"
  std::string_view summary;  // one sentence
  std::string_view source;   // paper and section, or empty
  std::span<const Parameter> parameters;
  std::span<const Quantity> quantities = {};  // of a metric
  std::span<const CurveDescription> curves = {};
  std::span<const std::string_view> basis = {};  // passes that must be there too: it works on their rows
  // What a scene must answer for this pass, beside what its samplers ask.
  Questions (*asks)(const Settings&) = [](const Settings&) { return Questions::none; };
  // What the table cannot say, such as a window that leaves the image: a phrase, or nothing.
  std::string (*problem)(const Settings&, const Extent&) = [](const Settings&, const Extent&) { return std::string(); };
};

}  // namespace moire
