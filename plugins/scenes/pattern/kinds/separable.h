// Patterns that are made of the product of a function of x and the same one of y.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "frame.h"
#include "weights/window.h"

namespace pattern {

// `Factor` is such a function, see factors.h, of the distance from the pattern's middle. `Kind` makes a grey of two of
// its values: `double grey(x, y) const`.
template <class Kind, class Factor>
class Separable : public PatternFrame<Kind> {
 public:
  Separable(const Look& look, const Factor& factor) : PatternFrame<Kind>(look), factor_(factor) {}

  moire::Hit at(moire::Point p) const {
    const moire::Point from_middle = p - this->look().middle();
    return {part(0), this->look().greys.mix(kind().grey(factor_.at(from_middle.x), factor_.at(from_middle.y)))};
  }

 protected:
  const Factor& factor() const { return factor_; }

  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override {
    if (!filter) {
      std::call_once(once_, [this] {
        const moire::ImageSize size = this->look().size;
        pixels_.emplace(this->look().middle(), moire::PixelArea{0, 0, size.width, size.height},
                        [this](double middle) { return factor_.over_pixel(middle); });
      });
      paint(*pixels_, block);
      return 0;
    }
    const Window window(*filter);
    const auto average = [&](double middle) { return factor_.under(window, middle); };
    paint(AxisAverages(this->look().middle(), block, average), block);
    return quadrature_error;
  }

 private:
  using Value = decltype(std::declval<Factor>().at(0));

  // Of the factor, in the columns and rows of an area.
  struct AxisAverages {
    template <class Average>
    AxisAverages(moire::Point middle, const moire::PixelArea& area, Average average) : x0(area.x0), y0(area.y0) {
      for (int x = 0; x < area.width; ++x) columns.push_back(average(x0 + x + 0.5 - middle.x));
      for (int y = 0; y < area.height; ++y) rows.push_back(average(y0 + y + 0.5 - middle.y));
    }
    Value column(int x) const { return columns[static_cast<std::size_t>(x - x0)]; }
    Value row(int y) const { return rows[static_cast<std::size_t>(y - y0)]; }

    int x0, y0;
    std::vector<Value> columns, rows;
  };

  const Kind& kind() const { return static_cast<const Kind&>(*this); }
  void paint(const AxisAverages& averages, moire::PixelBlock& block) const {
    this->fill(block, [&](int x, int y, auto deposit) {
      deposit(part(0), 1, this->look().greys.mix(kind().grey(averages.column(x), averages.row(y))));
    });
  }

  Factor factor_;
  mutable std::once_flag once_;
  mutable std::optional<AxisAverages> pixels_;  // of the whole image
};

}  // namespace pattern
