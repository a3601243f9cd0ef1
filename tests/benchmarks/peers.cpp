#include "peers.h"

#include <algorithm>
#include <cmath>

#ifdef MOIRE_HAS_CAIRO
#include <cairo/cairo.h>
#endif
#ifdef MOIRE_HAS_AGG
#include <agg2/agg_path_storage.h>
#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_scanline_p.h>
#include <agg2/agg_scanline_u.h>
#endif

namespace moire::benchmark {

namespace {

class Collector final : public PolygonSink {
 public:
  void polygon(const Polygon& polygon) override {
    PaintedLayer& layer = layers.emplace_back(PaintedLayer{polygon.color, polygon.rule, {}});
    for (std::size_t k = 0; k < polygon.contours.size(); ++k) {
      const std::size_t end = k + 1 < polygon.contours.size() ? polygon.contours[k + 1] : polygon.points.size();
      layer.contours.emplace_back(polygon.points.begin() + polygon.contours[k],
                                  polygon.points.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }
  std::vector<PaintedLayer> layers;
};

#ifdef MOIRE_HAS_CAIRO
class Cairo final : public Peer {
 public:
  Cairo(const std::vector<PaintedLayer>& layers, Color background, ImageSize size)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height), cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy),
        background_(background) {
    for (const PaintedLayer& layer : layers) {
      cairo_new_path(context_.get());
      for (const auto& contour : layer.contours) {
        for (std::size_t k = 0; k < contour.size(); ++k)
          (k == 0 ? cairo_move_to : cairo_line_to)(context_.get(), contour[k].x, contour[k].y);
        cairo_close_path(context_.get());
      }
      paths_.push_back({layer.color, layer.rule, {cairo_copy_path(context_.get()), cairo_path_destroy}});
    }
  }

  std::string name() const override { return std::string("Cairo ") + cairo_version_string(); }
  void draw() override {
    cairo_set_source_rgb(context_.get(), background_.r, background_.g, background_.b);
    cairo_paint(context_.get());
    for (const Path& path : paths_) {
      cairo_new_path(context_.get());
      cairo_append_path(context_.get(), path.path.get());
      cairo_set_fill_rule(context_.get(),
                          path.rule == FillRule::nonzero ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
      cairo_set_source_rgb(context_.get(), path.color.r, path.color.g, path.color.b);
      cairo_fill(context_.get());
    }
    cairo_surface_flush(surface_.get());
  }
  int code(int x, int y, int channel) const override {
    const unsigned char* row = cairo_image_surface_get_data(surface_.get()) +
                               static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
    return row[4 * x + 2 - channel];
  }

 private:
  struct Path {
    Color color;
    FillRule rule;
    std::unique_ptr<cairo_path_t, void (*)(cairo_path_t*)> path;
  };
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> context_;
  Color background_;
  std::vector<Path> paths_;
};
#endif

#ifdef MOIRE_HAS_AGG
class Agg final : public Peer {
 public:
  Agg(const std::vector<PaintedLayer>& layers, Color background, ImageSize size)
      : pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4),
        buffer_(pixels_.data(), static_cast<unsigned>(size.width), static_cast<unsigned>(size.height), size.width * 4),
        format_(buffer_),
        base_(format_),
        background_(rgba(background)),
        width_(size.width) {
    for (const PaintedLayer& layer : layers) {
      Path& path = paths_.emplace_back(Path{rgba(layer.color), layer.rule, {}});
      for (const auto& contour : layer.contours) {
        for (std::size_t k = 0; k < contour.size(); ++k)
          k == 0 ? path.path.move_to(contour[k].x, contour[k].y) : path.path.line_to(contour[k].x, contour[k].y);
        path.path.close_polygon();
      }
    }
    rasterizer_.clip_box(0, 0, size.width, size.height);
  }

  std::string name() const override { return "AGG scanline_u8"; }
  void draw() override {
    base_.clear(background_);
    for (Path& path : paths_) {
      rasterizer_.reset();
      rasterizer_.filling_rule(path.rule == FillRule::nonzero ? agg::fill_non_zero : agg::fill_even_odd);
      rasterizer_.add_path(path.path);
      agg::render_scanlines_aa_solid(rasterizer_, scanline_, base_, path.color);
    }
  }
  int code(int x, int y, int channel) const override {
    return pixels_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) +
                   static_cast<std::size_t>(channel)];
  }

 private:
  static agg::rgba8 rgba(Color c) { return agg::rgba8(agg::rgba(c.r, c.g, c.b)); }

  struct Path {
    agg::rgba8 color;
    FillRule rule;
    agg::path_storage path;
  };
  std::vector<unsigned char> pixels_;
  agg::rendering_buffer buffer_;
  agg::pixfmt_rgba32 format_;
  agg::renderer_base<agg::pixfmt_rgba32> base_;
  agg::rasterizer_scanline_aa<> rasterizer_;
  agg::scanline_u8 scanline_;
  agg::rgba8 background_;
  int width_;
  std::vector<Path> paths_;
};
#endif

}  // namespace

std::vector<PaintedLayer> painted_layers(const Frame& frame) {
  Collector collector;
  const ImageSize size = frame.size();
  frame.polygons()->stream({0, 0, static_cast<double>(size.width), static_cast<double>(size.height)}, collector);
  std::reverse(collector.layers.begin(), collector.layers.end());
  return collector.layers;
}

std::vector<std::unique_ptr<Peer>> peers([[maybe_unused]] const std::vector<PaintedLayer>& layers,
                                         [[maybe_unused]] Color background, [[maybe_unused]] ImageSize size) {
  std::vector<std::unique_ptr<Peer>> result;
#ifdef MOIRE_HAS_CAIRO
  result.push_back(std::make_unique<Cairo>(layers, background, size));
#endif
#ifdef MOIRE_HAS_AGG
  result.push_back(std::make_unique<Agg>(layers, background, size));
#endif
  return result;
}

}  // namespace moire::benchmark
