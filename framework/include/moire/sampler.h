// Samplers: how much of each element is visible in a pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <moire/frame.h>
#include <moire/random.h>
#include <moire/settings.h>

namespace moire {

// One sampler at work on one frame.
class Rendering {
 public:
  virtual ~Rendering() = default;
  // Deposits fragments into every pixel of the block. Called for many blocks at once.
  virtual void render(PixelBlock& block) const = 0;
  // The blocks that cost least. Columns: every block is of whole image columns. Rows: blocks may be any rectangles.
  virtual Blocks blocks() const { return Blocks::columns; }
  // After render(): no channel of a pixel rendered so far is farther from the exact value, of samplers that claim to be
  // exact; rounding aside.
  virtual double error_bound() const { return 0; }
};

// All that a sampler is given with a frame.
struct RenderRequest {
  const Frame& frame;
  const Lookup* lookup = nullptr;  // null: the scene's own colours
  const Filter* filter = nullptr;  // null: the box of one pixel; never given to a sampler that does not take filters
  std::uint64_t seed = 0;
  int frame_number = 0;
  // Of the same sampler on an earlier frame of the same scene: may save time, never changes the result. It is gone
  // after begin(), its frame may be gone before; several frames may begin from it at once.
  const Rendering* previous = nullptr;
};

// Immutable and safe to use from many threads.
class Sampler {
 public:
  virtual ~Sampler() = default;
  // Counts as time of the method. What `request` refers to outlives the rendering.
  virtual std::unique_ptr<Rendering> begin(const RenderRequest& request) const = 0;
};

// Where points on a pixel's lower edge lie in it: the last place above the next pixel.
inline constexpr double lower_edge = 1 - 0x1p-53;

// How far the points of a pattern are apart, in pixels: the part of a pixel that each stands for.
struct Spacing {
  double x = 1, y = 1;
};

// The points of one pixel. Where a frame has an area light, each of them sees it at one point: of those that give none
// the host chooses, for the points of a pixel together a lattice over the light, moved at random from pixel to pixel.
class Points {
 public:
  struct Entry {
    double x, y, weight;
    Point moved = {};                      // from its place in a regular pattern, which is what a filter weighs
    std::optional<LightPoint> light = {};  // nothing: the host chooses
  };
  // (x, y) in [0, 1) x [0, 1) of the pixel. Weights are divided by their sum.
  void add(double x, double y, double weight = 1) { entries_.push_back({x, y, weight}); }
  // A point of a regular pattern that was moved to (x, y): a filter gives it the weight of its place.
  void add_moved(Point place, double x, double y) { entries_.push_back({x, y, 1, {x - place.x, y - place.y}}); }

  // A point of the pixel and of the light.
  void add_lit(double x, double y, LightPoint light) { entries_.push_back({x, y, 1, {}, light}); }

  std::span<const Entry> entries() const { return entries_; }
  void clear() { entries_.clear(); }

 private:
  std::vector<Entry> entries_;
};

// A sampler that is a pattern of points. It says where they lie; tracing in coherent batches, lookups, fragments and
// threads are the host's.
class PointSampler {
 public:
  virtual ~PointSampler() = default;
  // Appends the points of this pixel to `out`, at least one.
  virtual void points(const Pixel& pixel, Points& out) const = 0;
  // True: points() is asked once for all pixels.
  virtual bool same_in_every_pixel() const { return false; }
  // Between its points: of n x n points, 1 / n each way. Nothing: the root of their number each way.
  virtual std::optional<Spacing> spacing() const { return {}; }
};

}  // namespace moire
