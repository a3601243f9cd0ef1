#include "texels.h"

#include <cmath>
#include <mutex>

#include <moire/error.h>
#include <moire/image.h>

namespace textured_plane {

namespace {

std::vector<float> padded(const std::vector<moire::Color>& colors) {
  std::vector<float> rgba;
  rgba.reserve(4 * colors.size());
  for (const moire::Color& c : colors) rgba.insert(rgba.end(), {c.r, c.g, c.b, 0});
  return rgba;
}

moire::Color mean_of(const std::vector<moire::Color>& colors) {
  double r = 0, g = 0, b = 0;
  for (const moire::Color& c : colors) {
    r += c.r;
    g += c.g;
    b += c.b;
  }
  const auto n = static_cast<double>(colors.size());
  return {static_cast<float>(r / n), static_cast<float>(g / n), static_cast<float>(b / n)};
}

std::vector<moire::Color> colors_of(const moire::Image& image, const std::string& file) {
  std::vector<moire::Color> colors;
  colors.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const moire::Color c = moire::color_at(image, x, y);
      if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
        throw moire::Error(file + ": colour at column " + std::to_string(x) + ", row " + std::to_string(y) +
                           " is not a finite number; every texel needs one");
      }
      colors.push_back(c);
    }
  }
  return colors;
}

moire::Wrap wrap_of(const std::string& name) {
  return name == "repeat" ? moire::Wrap::repeat : name == "mirror" ? moire::Wrap::mirror : moire::Wrap::clamp;
}

bool has_image(const moire::Settings& settings) { return !settings.text("texture").empty(); }

}  // namespace

struct Texels::Lazy {
  std::once_flag rows_made, columns_made, blocks_made;
  std::unique_ptr<LineSums> rows, columns;
  std::unique_ptr<Blocks> blocks;
};

Texels::Texels(const std::vector<moire::Color>& colors, int width, int height, moire::Wrap wrap)
    : rgba_(padded(colors)),
      texture_({{rgba_.data(), 4, width, height}}, wrap),
      mean_(mean_of(colors)),
      lazy_(std::make_unique<Lazy>()) {}

Texels::~Texels() = default;

const LineSums& Texels::rows() const {
  std::call_once(lazy_->rows_made,
                 [&] { lazy_->rows = std::make_unique<LineSums>(rgba_.data(), width(), height(), Along::s, wrap()); });
  return *lazy_->rows;
}

const LineSums& Texels::columns() const {
  std::call_once(lazy_->columns_made, [&] {
    lazy_->columns = std::make_unique<LineSums>(rgba_.data(), width(), height(), Along::t, wrap());
  });
  return *lazy_->columns;
}

const Blocks& Texels::blocks() const {
  std::call_once(lazy_->blocks_made,
                 [&] { lazy_->blocks = std::make_unique<Blocks>(rgba_.data(), width(), height()); });
  return *lazy_->blocks;
}

std::unique_ptr<Texels> load_texels(const moire::Settings& settings) {
  if (!has_image(settings)) {
    const moire::Color light = moire::parse_color(settings.text("light"));
    const moire::Color dark = moire::parse_color(settings.text("dark"));
    return std::make_unique<Texels>(std::vector{light, dark, dark, light}, 2, 2, moire::Wrap::repeat);
  }
  const std::string& file = settings.text("texture");
  const moire::Image image = moire::read_image(file);
  return std::make_unique<Texels>(colors_of(image, file), image.width, image.height, wrap_of(settings.text("wrap")));
}

double texel_size(const moire::Settings& settings) { return settings.real(has_image(settings) ? "scale" : "cell"); }

}  // namespace textured_plane
