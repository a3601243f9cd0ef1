// A metric pass at work on one contender and one scene.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <moire/sampler.h>

#include "metrics/description.h"
#include "metrics/merged.h"
#include "metrics/picture.h"

namespace moire {

// The exact content that fragments are held against.
enum class Against {
  nothing,  // fragments are not asked for
  column,   // of the upright line through the pixels' middles
  pixel,    // of the pixels: the fragments of the reference
};

// A number found; low and high are an interval or a spread, NaN where there is none.
struct Measurement {
  std::string_view quantity;  // Quantity::name
  double value;
  double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
};

// A number for each pixel, row 0 the top, for a picture.
struct Map {
  std::string_view kind;  // "error_absolute": shown from 0 to scale; "error_signed": from -scale to scale
  double scale;
  std::vector<double> values;
};

// A line of a chart: numbers y at x, both above 0.
struct Curve {
  std::string_view kind;  // CurveDescription::name
  std::vector<Point> points;
};

struct Judged {
  const Picture& picture;
  const Picture& reference;
  const Counters& counters;              // of the whole image
  const Frame* frame = nullptr;          // that was rendered
  const PointSampler* points = nullptr;  // the contender, if it is a pattern of points
  std::uint64_t seed = 0;                // of `picture`
  // The same frame by the same contender with independent random numbers, at least as many as replicates() asks for;
  // none if it draws none.
  std::span<const Picture> replicates = {};
};

class Metric {
 public:
  virtual ~Metric() = default;
  virtual Against against() const { return Against::nothing; }
  // Pictures wanted with other random numbers.
  virtual std::size_t replicates() const { return 0; }
  virtual void begin(ImageSize) {}
  // A block of whole image columns with its exact content. Called for many blocks at once, for every pixel once.
  // Requires: against() asks for fragments.
  virtual void block(const PixelBlock&, const MergedBlock&) {}
  virtual std::vector<Measurement> finish(const Judged& judged) = 0;
  // After finish.
  virtual std::vector<Map> maps() const { return {}; }
  virtual std::vector<Curve> curves() const { return {}; }
};

}  // namespace moire
