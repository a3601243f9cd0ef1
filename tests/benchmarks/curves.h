// Benchmarks of lines and circles drawn pixel by pixel: what each method costs a column, on a canvas of 8 bits.
#pragma once

#include <cstdint>
#include <vector>

#include "lines/octant.h"

namespace moire::benchmark {

// Grey, one byte a pixel.
class GreyCanvas {
 public:
  static constexpr int side = 1024;
  static constexpr PixelArea area{0, 0, side, side};

  GreyCanvas() : pixels_(std::size_t{side} * side) {}

  // Intensities of `full` replace what is there, or hide their share of it behind white.
  template <std::uint32_t full, bool blended>
  class Put {
   public:
    explicit Put(GreyCanvas& canvas) : pixels_(canvas.pixels_.data()) {}

    std::ptrdiff_t place(int x, int y) const { return std::ptrdiff_t{y} * side + x; }
    void at(std::ptrdiff_t place, std::uint32_t intensity) const {
      const std::uint32_t alpha = intensity * (255 / full);
      std::uint8_t& pixel = pixels_[place];
      if constexpr (blended) {
        // The product / 255, rounded.
        const std::uint32_t share = alpha * (255U - pixel) + 128;
        pixel = static_cast<std::uint8_t>(pixel + ((share + (share >> 8)) >> 8));
      } else {
        pixel = static_cast<std::uint8_t>(alpha);
      }
    }
    void operator()(int x, int y, std::uint32_t intensity) const { at(place(x, y), intensity); }

   private:
    std::uint8_t* pixels_;
  };

 private:
  std::vector<std::uint8_t> pixels_;
};

struct PixelLine {
  scan_conversion::PixelIndex from, to;
};

// Lines of this length in all directions, within the canvas. Equal for equal arguments.
std::vector<PixelLine> lines_of_length(double length, int count);

void run_curves();

}  // namespace moire::benchmark
