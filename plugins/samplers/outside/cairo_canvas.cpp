#include "cairo_canvas.h"

#include <cairo/cairo.h>

namespace outside {

namespace {

class Cairo final : public Canvas {
 public:
  explicit Cairo(const Painting& painting)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, painting.size.width, painting.size.height),
                 cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy),
        background_(painting.background) {
    for (const PaintedLayer& layer : painting.layers) {
      cairo_new_path(context_.get());
      for (const auto& contour : layer.contours) {
        for (std::size_t k = 0; k < contour.size(); ++k)
          (k == 0 ? cairo_move_to : cairo_line_to)(context_.get(), contour[k].x, contour[k].y);
        cairo_close_path(context_.get());
      }
      paths_.push_back({layer.color, layer.rule, {cairo_copy_path(context_.get()), cairo_path_destroy}});
    }
  }

  std::string name() const override { return "Cairo"; }
  void draw() override {
    cairo_set_source_rgb(context_.get(), background_.r, background_.g, background_.b);
    cairo_paint(context_.get());
    for (const Path& path : paths_) {
      cairo_new_path(context_.get());
      cairo_append_path(context_.get(), path.path.get());
      cairo_set_fill_rule(context_.get(),
                          path.rule == moire::FillRule::nonzero ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
      cairo_set_source_rgb(context_.get(), path.color.r, path.color.g, path.color.b);
      cairo_fill(context_.get());
    }
    cairo_surface_flush(surface_.get());
  }
  moire::Color codes(int x, int y) const override {
    const unsigned char* p = cairo_image_surface_get_data(surface_.get()) +
                             static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get()) + 4 * x;
    return {static_cast<float>(p[2]) / 255, static_cast<float>(p[1]) / 255, static_cast<float>(p[0]) / 255};
  }

 private:
  struct Path {
    moire::Color color;
    moire::FillRule rule;
    std::unique_ptr<cairo_path_t, void (*)(cairo_path_t*)> path;
  };
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> context_;
  moire::Color background_;
  std::vector<Path> paths_;
};

}  // namespace

std::unique_ptr<Canvas> cairo_canvas(const Painting& painting) { return std::make_unique<Cairo>(painting); }

}  // namespace outside
