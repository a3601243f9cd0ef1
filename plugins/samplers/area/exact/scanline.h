// One scanline of Catmull's algorithm: a strip of the picture, one pixel high.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <moire/tally.h>

#include "exact/integrator.h"
#include "exact/layers.h"
#include "exact/monotone.h"
#include "exact/path.h"

namespace area {

template <class Add>
class Scanline {
 public:
  Scanline(const Layers& layers, int width, bool jagged, moire::PixelBlock& block, Add add)
      : layers_(layers),
        width_(width),
        jagged_(jagged),
        block_(block),
        add_(add),
        x_bucket_(static_cast<std::size_t>(width), none) {}

  void begin(int y) {
    y_ = y;
    vertices_.clear();
    pieces_.clear();
  }

  // Breaks what lies of a polygon on the scanline into pieces and sorts them into the x-bucket.
  void add(const MonotonePolygon& polygon) {
    const double top = std::max(polygon.top() - y_, 0.0), bottom = std::min(polygon.bottom() - y_, 1.0);
    left_.clear();
    right_.clear();
    clip_side(polygon.left, top, bottom, left_);
    clip_side(polygon.right, top, bottom, right_);
    const auto by_x = [](moire::Point a, moire::Point b) { return a.x < b.x; };
    const auto [left_least, left_most] = std::minmax_element(left_.begin(), left_.end(), by_x);
    const auto [right_least, right_most] = std::minmax_element(right_.begin(), right_.end(), by_x);
    if (right_most->x <= 0 || left_least->x >= width_) return;

    // Pixels that are completely covered.
    int solid_begin = 0, solid_end = 0;
    if (top == 0 && bottom == 1) {
      solid_begin = static_cast<int>(std::ceil(std::clamp<double>(left_most->x, 0, width_)));
      solid_end = static_cast<int>(std::clamp<double>(right_least->x, 0, width_));
    }
    if (solid_begin >= solid_end) {
      irregular(polygon.layer, left_, right_);
      return;
    }
    const double end = solid_begin, begin = solid_end;
    if (left_least->x < end) irregular(polygon.layer, left_, {{end, 0}, {end, 1}});
    insert(solid_begin, {polygon.layer, true, 0, 0, solid_end, none});
    if (right_most->x > begin) irregular(polygon.layer, {{begin, 0}, {begin, 1}}, right_);
  }

  // Goes through the pixels from left to right.
  void deposit() {
    z_list_.clear();
    for (int x = 0; x < width_;) {
      for (std::uint32_t k = std::exchange(x_bucket_[static_cast<std::size_t>(x)], none); k != none;
           k = pieces_[k].next)
        enter(k);
      const bool irregular = !z_list_.empty() && !is_solid(z_list_.front());
      int next = x + 1;
      if (irregular) {
        pixel(x);
      } else {
        // A solid run goes on until something enters or it ends.
        const int end = z_list_.empty() ? width_ : pieces_[z_list_.front()].end;
        while (next < end && x_bucket_[static_cast<std::size_t>(next)] == none) ++next;
        run(x, next, z_list_.empty() ? layers_.background() : pieces_[z_list_.front()].layer);
      }
      leave(next);
      if (!irregular && !jagged_) {
        for (const std::uint32_t k : z_list_) {
          if (!is_solid(k)) cut_off(pieces_[k], next, nullptr);
        }
      }
      x = next;
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  // Part of a polygon on the scanline. Solid: it covers all its pixels and has no vertices.
  struct Piece {
    std::uint32_t layer;
    bool is_solid;
    std::size_t first_vertex, vertices;
    int end;             // behind the last pixel it reaches
    std::uint32_t next;  // in the same place of the x-bucket
  };

  bool is_solid(std::uint32_t piece) const { return pieces_[piece].is_solid; }

  // The part of a side between top and bottom, relative to the scanline.
  void clip_side(const std::vector<moire::Point>& side, double top, double bottom,
                 std::vector<moire::Point>& out) const {
    const auto below = [](double y, const moire::Point& p) { return y < p.y; };
    auto next = std::upper_bound(side.begin() + 1, side.end() - 1, y_ + top, below);
    out.push_back({x_on(next[-1], *next, y_ + top), top});
    for (; next->y < y_ + bottom; ++next) out.push_back({next->x, next->y - y_});
    out.push_back({x_on(next[-1], *next, y_ + bottom), bottom});
  }
  static double x_on(moire::Point p, moire::Point q, double y) {
    if (y <= p.y) return p.x;
    return y >= q.y ? q.x : x_at(p, q, y);
  }

  // The polygon between two sides, as a list of vertices: down the left side and up the right one.
  void irregular(std::uint32_t layer, const std::vector<moire::Point>& left, const std::vector<moire::Point>& right) {
    const std::size_t first = vertices_.size();
    vertices_.insert(vertices_.end(), left.begin(), left.end());
    vertices_.insert(vertices_.end(), right.rbegin(), right.rend());
    const auto [least, most] =
        std::minmax_element(vertices_.begin() + static_cast<std::ptrdiff_t>(first), vertices_.end(),
                            [](moire::Point a, moire::Point b) { return a.x < b.x; });
    if (most->x <= 0 || least->x >= width_) return vertices_.resize(first);
    const double begin = std::floor(std::max(least->x, 0.0));
    const int end = static_cast<int>(std::ceil(std::min<double>(most->x, width_)));
    Piece piece{layer, false, first, vertices_.size() - first, std::max(end, static_cast<int>(begin) + 1), none};
    if (least->x < 0) cut_off(piece, 0, nullptr);
    insert(static_cast<int>(begin), piece);
  }

  void insert(int pixel, Piece piece) {
    piece.next = std::exchange(x_bucket_[static_cast<std::size_t>(pixel)], static_cast<std::uint32_t>(pieces_.size()));
    pieces_.push_back(piece);
  }

  void enter(std::uint32_t piece) {
    const auto place = std::upper_bound(z_list_.begin(), z_list_.end(), piece, [&](std::uint32_t a, std::uint32_t b) {
      return pieces_[a].layer < pieces_[b].layer;
    });
    z_list_.insert(place, piece);
  }
  void leave(int pixel) {
    std::erase_if(z_list_, [&](std::uint32_t piece) { return pieces_[piece].end <= pixel; });
  }

  // Takes what lies left of x off a piece and gives it to `integrator`, if there is one, in its pixel's coordinates.
  void cut_off(Piece& piece, double x, PixelIntegrator* integrator) {
    rest_.clear();
    moire::Point p = vertices_[piece.first_vertex + piece.vertices - 1];
    for (std::size_t k = 0; k < piece.vertices; ++k) {
      const moire::Point q = vertices_[piece.first_vertex + k];
      if ((p.x < x && q.x > x) || (p.x > x && q.x < x)) {
        const moire::Point crossing{x, p.y + (x - p.x) * ((q.y - p.y) / (q.x - p.x))};
        if (integrator) integrator->vertex(1, crossing.y);
        rest_.push_back(crossing);
      }
      if (q.x <= x && integrator) integrator->vertex(q.x == x ? 1 : q.x - (x - 1), q.y);
      if (q.x >= x) rest_.push_back(q);
      p = q;
    }
    piece.first_vertex = vertices_.size();
    piece.vertices = rest_.size();
    vertices_.insert(vertices_.end(), rest_.begin(), rest_.end());
  }

  void pixel(int x) {
    if (jagged_) return jagged_pixel(x);
    integrator_.clear();
    // Pieces behind a solid one are not seen, but have to be clipped for the pixels to come.
    const auto solid = std::find_if(z_list_.begin(), z_list_.end(), [&](std::uint32_t k) { return is_solid(k); });
    for (auto k = z_list_.begin(); k != z_list_.end(); ++k) {
      if (is_solid(*k)) continue;
      if (k < solid) integrator_.begin_polygon(pieces_[*k].layer);
      cut_off(pieces_[*k], x + 1, k < solid ? &integrator_ : nullptr);
    }
    integrator_.solid(solid == z_list_.end() ? layers_.background() : pieces_[*solid].layer);
    if (!is_wanted(x)) return;
    for (const PixelIntegrator::Visible& visible : integrator_.integrate())
      add_(block_.slot(x, y_), layers_[visible.layer].element, visible.area, layers_[visible.layer].color);
  }

  // The foremost piece at the pixel's middle; nothing needs clipping.
  void jagged_pixel(int x) {
    if (!is_wanted(x)) return;
    const auto front = std::find_if(z_list_.begin(), z_list_.end(),
                                    [&](std::uint32_t k) { return is_solid(k) || is_inside(pieces_[k], x + 0.5); });
    const Layer& layer = layers_[front == z_list_.end() ? layers_.background() : pieces_[*front].layer];
    add_(block_.slot(x, y_), layer.element, 1, layer.color);
  }
  // Of the point (x, 1/2). As a sampler of points would have it, a point on a left side is inside.
  bool is_inside(const Piece& piece, double x) const {
    constexpr double y = 0.5;
    bool inside = false;
    moire::Point p = vertices_[piece.first_vertex + piece.vertices - 1];
    for (std::size_t k = piece.first_vertex; k < piece.first_vertex + piece.vertices; ++k) {
      const moire::Point q = vertices_[k];
      if ((p.y <= y) != (q.y <= y) && p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y)) <= x) inside = !inside;
      p = q;
    }
    return inside;
  }

  bool is_wanted(int x) const { return x >= block_.x0 && x < block_.x0 + block_.width; }

  void run(int begin, int end, std::uint32_t layer) {
    const int first = std::max(begin, block_.x0), last = std::min(end, block_.x0 + block_.width);
    if (first >= last) return;
    if (!block_.recording() && block_.across() == 1) {
      return block_.add_run({block_.slot(first, y_), static_cast<std::size_t>(last - first), layers_[layer].color});
    }
    for (int x = first; x < last; ++x) add_(block_.slot(x, y_), layers_[layer].element, 1, layers_[layer].color);
  }

  const Layers& layers_;
  const int width_;
  const bool jagged_;
  moire::PixelBlock& block_;
  const Add add_;
  int y_ = 0;
  std::vector<moire::Point> vertices_, left_, right_, rest_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> x_bucket_;  // by the leftmost pixel, the first piece
  std::vector<std::uint32_t> z_list_;    // pieces, the foremost first
  PixelIntegrator integrator_;
};

}  // namespace area
