#include "photograph_plane.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <moire/image.h>

namespace moire::benchmark {

namespace {

using Rgb = std::array<double, 3>;

std::vector<float> photograph(int& width, int& height) {
  const Image image = read_image(std::filesystem::path(std::getenv("MOIRE_DATA")) / "texture/naip_airfield_1024.png");
  width = image.width;
  height = image.height;
  std::vector<float> rgb;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Color c = color_at(image, x, y);
      rgb.insert(rgb.end(), {c.r, c.g, c.b});
    }
  }
  return rgb;
}

Texture repeated(const std::vector<float>& rgb, int width, int height) {
  return {{{rgb.data(), 3, width, height}}, Wrap::repeat};
}

// The integrals of a texture's rows along s.
class RowIntegrals {
 public:
  explicit RowIntegrals(const Texture& texture) : width_(texture.level(0).width), height_(texture.level(0).height) {
    for (int j = 0; j < height_; ++j) {
      Rgb sum{};
      sums_.push_back(sum);
      for (int i = 0; i < width_; ++i) {
        const Color c = texture.texel(0, i, j).color;
        sum = {sum[0] + static_cast<double>(c.r), sum[1] + static_cast<double>(c.g), sum[2] + static_cast<double>(c.b)};
        sums_.push_back(sum);
      }
    }
  }

  Rgb at(double s, std::int64_t row) const {
    const double copies = std::floor(s / width_), inside = s - copies * width_;
    const auto i = std::min(static_cast<int>(inside), width_ - 1);
    const Rgb* const sums = sums_.data() + wrapped(row, height_, Wrap::repeat) * (width_ + 1);
    Rgb result;
    for (std::size_t c = 0; c < 3; ++c) {
      result[c] = copies * sums[width_][c] + sums[i][c] + (inside - i) * (sums[i + 1][c] - sums[i][c]);
    }
    return result;
  }

 private:
  int width_, height_;
  std::vector<Rgb> sums_;
};

}  // namespace

PhotographPlane::PhotographPlane() : texture_({}, Wrap::repeat) {
  int width = 0, length = 0;
  texels_ = photograph(width, length);
  texture_ = repeated(texels_, width, length);
  for (int row = 1; row <= rows; ++row) {
    for (int x = 0; x < columns; ++x) {
      const double below = row + 0.5, aside = x + 0.5 - columns / 2.0;
      const double distance = height * focal / below;
      SurfacePoint point;
      point.textured = true;
      point.s = aside * distance / focal;
      point.t = distance;
      point.ds_dx = static_cast<float>(distance / focal);
      point.ds_dy = static_cast<float>(-point.s / below);
      point.dt_dy = static_cast<float>(-distance / below);
      points_.push_back(point);
    }
  }
}

// On a horizontal line k pixels below the horizon the place is (x h / k, h f / k). Between places where either is whole
// the integral over all x left of a pixel's border is linear in k: the midpoint rule gives it exactly.
std::vector<Rgb> PhotographPlane::exact() const {
  const RowIntegrals integrals(texture_);
  std::vector<Rgb> pixels;
  for (int row = 1; row <= rows; ++row) {
    std::vector<Rgb> borders;
    for (int x = 0; x <= columns; ++x) {
      const double across = (x - columns / 2) * height, along = height * focal;
      const double far = 1.0 / row;
      Rgb sum{};
      for (double near = 1.0 / (row + 1); near < far;) {
        // Inverse distances from the horizon at which the next texel begins, a step beyond the last one to get on.
        const double step = near * 1e-12;
        double next = std::min(far, (std::floor((near + step) * along) + 1) / along);
        if (across != 0) next = std::min(next, (std::floor((near + step) * std::abs(across)) + 1) / std::abs(across));
        const double k = (1 / near + 1 / next) / 2, width = 1 / near - 1 / next;
        const Rgb integral = integrals.at(across / k, static_cast<std::int64_t>(along / k));
        for (std::size_t c = 0; c < 3; ++c) sum[c] += width * k / height * integral[c];
        near = next;
      }
      borders.push_back(sum);
    }
    for (std::size_t x = 0; x < columns; ++x) {
      Rgb pixel;
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = borders[x + 1][c] - borders[x][c];
      pixels.push_back(pixel);
    }
  }
  return pixels;
}

}  // namespace moire::benchmark
