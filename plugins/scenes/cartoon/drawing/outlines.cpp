#include "outlines.h"

#include <atomic>
#include <cmath>

#include <fmt/format.h>

#include <moire/error.h>

#include "chords.h"

namespace cartoon {

namespace {

using moire::Point;

constexpr double most_points = 1 << 26;  // a gigabyte

std::atomic<std::uint64_t> last_identity = 0;

// Calls visit(verb, from, points) for all parts of all outlines, and end_layer(k) after each layer.
template <class Visit, class EndLayer>
void for_each_part(const Drawing& drawing, Visit visit, EndLayer end_layer) {
  const Point* p = drawing.points.data();
  Point at;
  for (std::size_t k = 0; k < drawing.layers.size(); ++k) {
    for (std::size_t v = drawing.layers[k].first_verb; v < drawing.verb_end(k); ++v) {
      const Verb verb = drawing.verbs[v];
      visit(verb, at, p);
      p += points_of(verb);
      at = p[-1];
    }
    end_layer(k);
  }
}

}  // namespace

moire::Color color_of(Rgb code, moire::Blend blend) {
  const auto channel = [&](std::uint8_t value) {
    const double stored = value / 255.0;
    return static_cast<float>(blend == moire::Blend::linear ? moire::srgb_to_linear(stored) : stored);
  };
  return {channel(code.r), channel(code.g), channel(code.b)};
}

Outlines::Outlines(const Drawing& drawing, double tolerance, moire::Blend blend) : identity_(++last_identity) {
  double count = 0;
  for_each_part(
      drawing, [&](Verb verb, Point from, const Point* p) { count += chords_of(verb, from, p, tolerance); },
      [](std::size_t) {});
  if (!(count <= most_points)) {
    throw moire::Error(
        fmt::format("cartoon: the outlines take {:.3g} points at this scale; at most {:.3g} are drawn, "
                    "with a larger \"tolerance\" or a smaller \"view.zoom\" they are fewer",
                    count, most_points));
  }
  points_.reserve(static_cast<std::size_t>(count));
  layers_.reserve(drawing.layers.size() + 1);

  std::size_t first = 0;  // of the contour
  const auto put = [&](Point p) {
    if (points_.size() == first || p != points_.back()) points_.push_back(p);
  };
  const auto begin_layer = [&](std::size_t k) {
    const cartoon::Layer& layer = drawing.layers[k];
    layers_.push_back({points_.size(), contours_.size(), color_of(layer.color, blend), layer.rule});
  };
  if (!drawing.layers.empty()) begin_layer(0);
  for_each_part(
      drawing,
      [&](Verb verb, Point from, const Point* p) {
        if (verb == Verb::move) {
          finish_contour(first);
          first = points_.size();
          return put(p[0]);
        }
        put_chords(verb, from, p, static_cast<std::size_t>(chords_of(verb, from, p, tolerance)), put);
      },
      [&](std::size_t k) {
        finish_contour(first);
        first = points_.size();
        if (k + 1 < drawing.layers.size()) begin_layer(k + 1);
      });
  layers_.push_back({points_.size(), contours_.size(), {}, {}});
}

// Contours that enclose nothing are left out.
void Outlines::finish_contour(std::size_t first) {
  while (points_.size() > first + 1 && points_.back() == points_[first]) points_.pop_back();
  if (points_.size() < first + 3) return points_.resize(first);
  contours_.push_back(static_cast<std::uint32_t>(first - layers_.back().first_point));
}

}  // namespace cartoon
