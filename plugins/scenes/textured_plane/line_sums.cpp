#include "line_sums.h"

namespace textured_plane {

LineSums::LineSums(const float* rgba, int width, int height, Along along, moire::Wrap wrap) : wrap_(wrap) {
  const int length = along == Along::s ? width : height;
  lines_ = along == Along::s ? height : width;
  period_ = wrap == moire::Wrap::mirror ? 2 * length : length;
  const std::size_t step = along == Along::s ? 4 : 4 * static_cast<std::size_t>(width);
  const std::size_t next_line = along == Along::s ? 4 * static_cast<std::size_t>(width) : 4;

  means_.reserve(static_cast<std::size_t>(lines_));
  nodes_.reserve(static_cast<std::size_t>(lines_) * (static_cast<std::size_t>(period_) + 1));
  for (int n = 0; n < lines_; ++n) {
    const float* first = rgba + static_cast<std::size_t>(n) * next_line;
    Node mean{};
    for (int i = 0; i < length; ++i) {
      const float* c = first + static_cast<std::size_t>(i) * step;
      mean = {mean.r + c[0], mean.g + c[1], mean.b + c[2], 0};
    }
    mean = {mean.r / length, mean.g / length, mean.b / length, 0};
    means_.push_back(mean);

    Node sum{};
    for (int i = 0; i < period_; ++i) {
      nodes_.push_back(sum);
      const float* c = first + static_cast<std::size_t>(moire::wrapped(i, length, wrap)) * step;
      sum = {sum.r + (c[0] - mean.r), sum.g + (c[1] - mean.g), sum.b + (c[2] - mean.b), 0};
    }
    nodes_.push_back({});
  }
}

}  // namespace textured_plane
