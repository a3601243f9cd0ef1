#include <moire/pyramid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace moire {

namespace {

using Texel = std::array<double, 3>;

// The averages of a row of texels over `count` equal stretches: differences of its integral.
void average(const std::vector<Texel>& row, std::vector<Texel>& out) {
  const auto size = row.size(), count = out.size();
  for (std::size_t i = 0; i < count; ++i) {
    // In texels, by whole numbers: from first + (first part) / count to last + (last part) / count.
    const std::size_t begin = i * size, end = (i + 1) * size;
    Texel sum{};
    for (std::size_t k = begin / count; k * count < end; ++k) {
      const auto part = static_cast<double>(std::min((k + 1) * count, end) - std::max(k * count, begin));
      for (std::size_t c = 0; c < 3; ++c) sum[c] += part * row[k][c];
    }
    for (std::size_t c = 0; c < 3; ++c) out[i][c] = sum[c] / static_cast<double>(size);
  }
}

}  // namespace

Pyramid::Pyramid(const float* rgb, std::size_t stride, int width, int height) {
  const auto w0 = static_cast<std::size_t>(width), h0 = static_cast<std::size_t>(height);
  for (int l = 0; l == 0 || (std::max(width, height) >> (l - 1)) > 1; ++l) {
    const int own_width = std::max(1, width >> l), own_height = std::max(1, height >> l);
    Level level{
        own_width, own_height, static_cast<double>(own_width) / width, static_cast<double>(own_height) / height, {}};
    const auto w = static_cast<std::size_t>(own_width), h = static_cast<std::size_t>(own_height);
    level.rgba.resize(4 * w * h);

    // Rows of level 0 to this level's width, then columns of those to its height.
    std::vector<Texel> narrow(w * h0), row(w0), shorter(w);
    for (std::size_t j = 0; j < h0; ++j) {
      for (std::size_t i = 0; i < w0; ++i) {
        const float* texel = rgb + (j * w0 + i) * stride;
        row[i] = {texel[0], texel[1], texel[2]};
      }
      average(row, shorter);
      for (std::size_t i = 0; i < w; ++i) narrow[j * w + i] = shorter[i];
    }
    std::vector<Texel> column(h0), lower(h);
    for (std::size_t i = 0; i < w; ++i) {
      for (std::size_t j = 0; j < h0; ++j) column[j] = narrow[j * w + i];
      average(column, lower);
      for (std::size_t j = 0; j < h; ++j) {
        for (std::size_t c = 0; c < 3; ++c) level.rgba[4 * (j * w + i) + c] = static_cast<float>(lower[j][c]);
      }
    }
    levels_.push_back(std::move(level));
  }
}

}  // namespace moire
