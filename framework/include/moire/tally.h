// What samplers deposit: fragments, summed per slot and kept one by one where a metric asked for them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <moire/color.h>
#include <moire/element.h>

namespace moire {

// Work done, counted by scenes and by the host; one per tally, so that counting needs no atomics.
struct Counters {
  std::uint64_t queries = 0;  // points asked for, or stretches of a line
  std::uint64_t hits = 0;     // queries answered by an element other than the background; of a line: its runs
  std::uint64_t steps = 0;    // elements stepped over from a batch's first hit to its last (L of Cohen-Or 1997)

  Counters& operator+=(const Counters& other) {
    queries += other.queries;
    hits += other.hits;
    steps += other.steps;
    return *this;
  }
  friend bool operator==(const Counters&, const Counters&) = default;
};

// One deposit: an element, how much of the slot it takes (any unit: divided by the slot's sum), its colour.
struct Fragment {
  Element element = background;
  double weight = 0;
  Color color;
};

// Sums of a row of slots. A slot is a pixel, or whatever else its owner makes of it.
class Tally {
 public:
  // Of weights, and of weights times colours.
  struct Sum {
    double weight = 0, r = 0, g = 0, b = 0;

    void add(double w, Color color) {
      weight += w;
      r += w * color.r;
      g += w * color.g;
      b += w * color.b;
    }
    void add(const Sum& other) {
      weight += other.weight;
      r += other.r;
      g += other.g;
      b += other.b;
    }
    friend bool operator==(const Sum&, const Sum&) = default;
  };

  Tally(std::size_t slots, bool recording) : recording_(recording) { reset(slots); }

  // Empties all slots and makes `slots` of them.
  void reset(std::size_t slots) {
    if (slots != sums_.size()) {
      sums_.assign(slots, Sum{});
    } else {
      // The slots of runs have been left empty.
      auto from = sums_.begin();
      for (const Run& run : runs_) {
        std::fill(from, sums_.begin() + static_cast<std::ptrdiff_t>(run.first), Sum{});
        from = sums_.begin() + static_cast<std::ptrdiff_t>(run.first + run.count);
      }
      std::fill(from, sums_.end(), Sum{});
    }
    runs_.clear();
    entries_.clear();
    if (recording_) chains_.assign(slots, Chain{});
    counters = {};
  }

  std::size_t slots() const { return sums_.size(); }
  bool recording() const { return recording_; }

  void add(std::size_t slot, Element element, double weight, Color color) {
    sums_[slot].add(weight, color);
    if (recording_) record(slot, element, weight, color);
  }

  // Tally::add with the question "recording?" decided once, outside the loop.
  template <bool recorded>
  class Adder {
   public:
    explicit Adder(Tally& tally) : tally_(tally) {}

    void operator()(std::size_t slot, Element element, double weight, Color color) const {
      tally_.sums_[slot].add(weight, color);
      record(slot, element, weight, color);
    }
    // The same in two halves, for loops that deposit many fragments into one slot: the fragment now, and the sum of
    // all of them, kept by the caller, once at the end.
    void record(std::size_t slot, Element element, double weight, Color color) const {
      if constexpr (recorded) tally_.record(slot, element, weight, color);
    }
    void sum(std::size_t slot, const Sum& all) const { tally_.sums_[slot].add(all); }

   private:
    Tally& tally_;
  };

  // Calls body(add), add an Adder. For hot loops.
  template <class Body>
  void fill(Body&& body) {
    if (recording_) {
      body(Adder<true>(*this));
    } else {
      body(Adder<false>(*this));
    }
  }

  // Slots side by side that each get one deposit of weight 1 and no other.
  struct Run {
    std::size_t first, count;
    Color color;
  };
  // Kept as they are until settle(): before it nothing else can be asked of their slots. For samplers that fill large
  // parts of a picture. Requires: not recording; behind the runs before it.
  void add_run(const Run& run) { runs_.push_back(run); }
  const std::vector<Run>& runs() const { return runs_; }
  void settle() {
    for (const Run& run : runs_) {
      const Sum sum{1, run.color.r, run.color.g, run.color.b};
      std::fill_n(sums_.begin() + static_cast<std::ptrdiff_t>(run.first), run.count, sum);
    }
    runs_.clear();
  }

  // Adds slot `source` of `from`, weights times `factor`, fragments in their order. Requires: `from` records if this
  // does.
  void mix(std::size_t slot, const Tally& from, std::size_t source, double factor) {
    const Sum& other = from.sums_[source];
    Sum& sum = sums_[slot];
    sum.weight += factor * other.weight;
    sum.r += factor * other.r;
    sum.g += factor * other.g;
    sum.b += factor * other.b;
    if (recording_) {
      from.for_each(source, [&](const Fragment& f) { record(slot, f.element, factor * f.weight, f.color); });
    }
  }

  // The sum of the slot's weights; 1 where exact area weights fill a pixel.
  double weight(std::size_t slot) const { return sums_[slot].weight; }

  const Sum& sum(std::size_t slot) const { return sums_[slot]; }

  // sum w c / sum w; black where nothing was deposited.
  Color color(std::size_t slot) const {
    const Sum& s = sums_[slot];
    if (s.weight == 0) return {};
    return {static_cast<float>(s.r / s.weight), static_cast<float>(s.g / s.weight), static_cast<float>(s.b / s.weight)};
  }

  // The recorded fragments of a slot in the order of deposit. Nothing unless recording.
  template <class Visit>
  void for_each(std::size_t slot, Visit&& visit) const {
    if (!recording_) return;
    for (std::uint32_t e = chains_[slot].first; e != none; e = entries_[e].next) visit(entries_[e].fragment);
  }

  Counters counters;

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Chain {
    std::uint32_t first = none, last = none;
  };
  struct Entry {
    Fragment fragment;
    std::uint32_t next;
  };

  void record(std::size_t slot, Element element, double weight, Color color) {
    const auto index = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({{element, weight, color}, none});
    Chain& chain = chains_[slot];
    if (chain.first == none) {
      chain.first = index;
    } else {
      entries_[chain.last].next = index;
    }
    chain.last = index;
  }

  bool recording_;
  std::vector<Sum> sums_;
  std::vector<Run> runs_;
  std::vector<Entry> entries_;
  std::vector<Chain> chains_;
};

// A rectangle of pixels.
struct PixelArea {
  int x0 = 0, y0 = 0, width = 0, height = 0;
  friend bool operator==(const PixelArea&, const PixelArea&) = default;
};

// Which pixels of a block lie side by side: those of an image column, or those of a row.
enum class Blocks { columns, rows };

// What a frame's colours are, and so what is averaged: linear light, or the sRGB code values (0 .. 1) that files store.
// The host turns averages of code values into light when they are pixels.
enum class Blend { linear, as_stored };

// The slots of a rectangle of pixels.
class PixelBlock : public Tally, public PixelArea {
 public:
  PixelBlock(PixelArea area, bool recording, Blocks order = Blocks::columns, Blend blend = Blend::linear)
      : Tally(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height), recording),
        PixelArea(area),
        order_(order),
        blend_(blend) {}

  // Becomes an empty block of other pixels.
  void move_to(PixelArea area) {
    static_cast<PixelArea&>(*this) = area;
    reset(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
  }

  std::size_t slot(int x, int y) const {
    return static_cast<std::size_t>(x - x0) * across() + static_cast<std::size_t>(y - y0) * down();
  }
  // From a pixel's slot to that of its neighbour to the right, and of its neighbour below.
  std::size_t across() const { return order_ == Blocks::columns ? static_cast<std::size_t>(height) : 1; }
  std::size_t down() const { return order_ == Blocks::columns ? 1 : static_cast<std::size_t>(width); }

  Blocks order() const { return order_; }
  Blend blend() const { return blend_; }

  // The pixel's colour, in linear light whatever was averaged; black where nothing was deposited.
  Color color(std::size_t slot) const {
    return blend_ == Blend::linear ? Tally::color(slot) : light_of_codes(sum(slot));
  }
  // The colour of a fragment as it is shown, in linear light.
  Color light(Color deposited) const {
    if (blend_ == Blend::linear) return deposited;
    Sum one;
    one.add(1, deposited);
    return light_of_codes(one);
  }

 private:
  // Of an average of code values; rounded to floats only once.
  static Color light_of_codes(const Sum& s) {
    if (s.weight == 0) return {};
    const auto channel = [&](double code) { return static_cast<float>(srgb_to_linear(code / s.weight)); };
    return {channel(s.r), channel(s.g), channel(s.b)};
  }

  Blocks order_;
  Blend blend_;
};

}  // namespace moire
