// A scene as seen in one image at one instant, and the questions it can be asked.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include <moire/curves.h>
#include <moire/filter.h>
#include <moire/geometry.h>
#include <moire/receivers.h>
#include <moire/tally.h>
#include <moire/texture.h>

namespace moire {

// A straight line in the image and the stretches it is cut into: stretch i lies between cuts[i] and cuts[i + 1], which
// are distances from `from` in pixels, not falling, within the line.
struct ImageLine {
  Point from, to;
  std::span<const double> cuts;

  std::size_t stretches() const { return cuts.empty() ? 0 : cuts.size() - 1; }
};

// What is seen along lines of the image.
class Lines {
 public:
  virtual ~Lines() = default;

  // Deposits what is seen on each line, a stretch a slot: those of the first line, then those of the second, and so on.
  // A fragment's weight is its length in pixels. What a line gets does not depend on the others; they come together so
  // that a scene may follow many at once. `lookup` null: the scene's own colours, one fragment a run.
  // Requires: pieces has as many slots as the lines have stretches; from != to.
  virtual void along(std::span<const ImageLine> lines, const Lookup* lookup, Tally& pieces) const = 0;

  // The point through which image lines are exact and coherent (the nadir of a camera above a landscape), if any.
  virtual std::optional<Pole> pole() const { return std::nullopt; }
};

enum class FillRule { nonzero, even_odd };

struct Polygon {
  Element element;
  Color color;
  FillRule rule;
  std::span<const Point> points;            // of all contours, one after another, closed implicitly
  std::span<const std::uint32_t> contours;  // index of each contour's first point
};

class PolygonSink {
 public:
  virtual ~PolygonSink() = default;
  virtual void polygon(const Polygon&) = 0;
};

// Polygons that many frames show, each in its own place: what was found out about it once serves them all.
class Artwork {
 public:
  virtual ~Artwork() = default;
  // No other artwork of this process has this number; those of one number are equal to the bit.
  virtual std::uint64_t identity() const = 0;
  // From its own coordinates to the image.
  virtual Affine placement() const = 0;
  // All polygons in its own coordinates, front to back.
  virtual void stream(PolygonSink& sink) const = 0;
};

// The polygons that make up the picture.
class Polygons {
 public:
  virtual ~Polygons() = default;
  // True: no two overlap, the scene has resolved visibility. False: they come front to back.
  virtual bool disjoint() const = 0;
  // All polygons that touch the window, in image coordinates, one call of the sink each. What no polygon covers is
  // the background, in this colour.
  virtual void stream(const Rectangle& window, PolygonSink& sink) const = 0;
  virtual Color background_color() const = 0;
  // The artwork that these polygons are, if they may come again in another frame.
  virtual const Artwork* artwork() const { return nullptr; }
};

// Where on a texture image points lie.
class Surface {
 public:
  virtual ~Surface() = default;
  // As Frame::trace. Requires: points.size() == out.size().
  virtual void locate(std::span<const SamplePoint> points, std::span<SurfacePoint> out, Counters& counters) const = 0;
  virtual const Texture& texture() const = 0;
};

// Exact averages over pixels, where the scene has a closed form or a bounded quadrature for them.
class Averages {
 public:
  virtual ~Averages() = default;
  // Deposits the content of every pixel of the block: weights sum to 1. `filter` null: the pixel's own square; others
  // only if the scene answers Questions::filtered_averages. Returns a bound on the error of any channel of any of
  // these pixels, 0 where rounding is all there is. Recorded fragments name elements as trace() does.
  virtual double integrate(const Filter* filter, PixelBlock& block) const = 0;
  // The blocks that cost least. Rows: blocks may be any rectangles.
  virtual Blocks blocks() const { return Blocks::rows; }
};

// amplitude * cos(2 pi (fx x + fy y) + phase), frequencies in cycles a pixel, phase in radians at (0, 0) of the image.
struct Sinusoid {
  double amplitude, fx, fy, phase;
};

// What a picture of known frequencies is made of. All channels are equal.
class Spectrum {
 public:
  virtual ~Spectrum() = default;
  // The picture is a constant and the sum of these. Empty: it is no such sum.
  virtual std::span<const Sinusoid> sinusoids() const { return {}; }
  // Of a picture of one wave whose frequency changes from place to place (zone plate): the larger of |fx| and |fy| at
  // a point, cycles a pixel. NaN: it is no such picture.
  virtual double local_frequency(Point) const { return std::numeric_limits<double>::quiet_NaN(); }
  // Of that wave, about its mean.
  virtual double amplitude() const { return 0; }
};

// Immutable, and safe to use from many threads. A question that the scene has no structure for is a null pointer.
class Frame {
 public:
  virtual ~Frame() = default;

  virtual ImageSize size() const = 0;
  virtual Blend blend() const { return Blend::linear; }

  // What is seen at each point. Points of one batch that follow each other upward on one line may be answered from
  // one another. Requires: points.size() == hits.size().
  virtual void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const = 0;

  virtual const Lines* lines() const { return nullptr; }
  virtual const Polygons* polygons() const { return nullptr; }
  virtual const Surface* surface() const { return nullptr; }
  virtual const Curves* curves() const { return nullptr; }
  // Null: the light is no area, and (u, v) of a sample point means nothing.
  virtual const Receivers* receivers() const { return nullptr; }
  virtual const Averages* averages() const { return nullptr; }
  virtual const Spectrum* spectrum() const { return nullptr; }
};

}  // namespace moire
