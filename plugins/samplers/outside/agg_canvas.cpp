#include "agg_canvas.h"

#include <agg2/agg_path_storage.h>
#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_scanline_u.h>

namespace outside {

namespace {

class Agg final : public Canvas {
 public:
  explicit Agg(const Painting& painting)
      : pixels_(static_cast<std::size_t>(painting.size.width) * static_cast<std::size_t>(painting.size.height) * 4),
        buffer_(pixels_.data(), static_cast<unsigned>(painting.size.width), static_cast<unsigned>(painting.size.height),
                painting.size.width * 4),
        format_(buffer_),
        base_(format_),
        background_(rgba(painting.background)),
        width_(painting.size.width) {
    for (const PaintedLayer& layer : painting.layers) {
      Path& path = paths_.emplace_back(Path{rgba(layer.color), layer.rule, {}});
      for (const auto& contour : layer.contours) {
        for (std::size_t k = 0; k < contour.size(); ++k)
          k == 0 ? path.path.move_to(contour[k].x, contour[k].y) : path.path.line_to(contour[k].x, contour[k].y);
        path.path.close_polygon();
      }
    }
    rasterizer_.clip_box(0, 0, painting.size.width, painting.size.height);
  }

  std::string name() const override { return "AGG"; }
  void draw() override {
    base_.clear(background_);
    for (Path& path : paths_) {
      rasterizer_.reset();
      rasterizer_.filling_rule(path.rule == moire::FillRule::nonzero ? agg::fill_non_zero : agg::fill_even_odd);
      rasterizer_.add_path(path.path);
      agg::render_scanlines_aa_solid(rasterizer_, scanline_, base_, path.color);
    }
  }
  moire::Color codes(int x, int y) const override {
    const unsigned char* p =
        &pixels_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x))];
    return {static_cast<float>(p[0]) / 255, static_cast<float>(p[1]) / 255, static_cast<float>(p[2]) / 255};
  }

 private:
  static agg::rgba8 rgba(moire::Color c) { return agg::rgba8(agg::rgba(c.r, c.g, c.b)); }

  struct Path {
    agg::rgba8 color;
    moire::FillRule rule;
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

}  // namespace

std::unique_ptr<Canvas> agg_canvas(const Painting& painting) { return std::make_unique<Agg>(painting); }

}  // namespace outside
