// What a window of pixels sees and what of it is sampled: Cohen-Or 1997, section 4.3, Fig. 9; in plan, or on the image.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pictures/footprint_plan.h"
#include "pictures/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr int magnification = 8;   // on the image
constexpr int widest_shown = 512;  // pixels of a window on the image; more would be a picture of more than 4096

constexpr Parameter parameters[] = {
    choice("in", "plan", "plan image", "the map from above, or the pixels of the window"),
    integer("window.x", 0, 0, 16383, "pixels", "left edge of the window"),
    integer("window.y", 0, 0, 16383, "pixels", "upper edge of the window"),
    integer("window.width", 32, 1, 16384, "pixels", "columns of the window"),
    integer("window.height", 32, 1, 16384, "pixels", "rows of the window"),
};

class Footprint : public PicturePass {
 public:
  explicit Footprint(const Settings& settings)
      : window_{static_cast<int>(settings.integer("window.x")), static_cast<int>(settings.integer("window.y")),
                static_cast<int>(settings.integer("window.width")),
                static_cast<int>(settings.integer("window.height"))} {}

  Needs needs() const override { return {.columns = {window_.x0, window_.width}, .fragments = true, .exact = true}; }

 protected:
  template <class Visit>
  void for_each_pixel(const FrameView& view, Visit visit) const {
    std::vector<ElementWeight> own;
    for (int y = window_.y0; y < window_.y0 + window_.height; ++y) {
      for (int x = window_.x0; x < window_.x0 + window_.width; ++x) {
        const std::size_t slot = view.own.slot(x, y);
        merge(view.own, slot, own);
        visit(x - window_.x0, y - window_.y0, std::span<const ElementWeight>(own), view.exact->pixel(slot));
      }
    }
  }
  std::string place() const {
    return fmt::format("Window of {} x {} pixels at ({}, {})", window_.width, window_.height, window_.x0, window_.y0);
  }

  PixelArea window_;
};

class FootprintInPlan final : public Footprint {
 public:
  using Footprint::Footprint;

  void see(const FrameView& view) override {
    for_each_pixel(view, [&](int, int, auto own, auto exact) {
      for (const ElementWeight& e : own) seen_.push_back(e.element);
      for (const ElementWeight& e : exact) visible_.push_back(e.element);
    });
    for (std::vector<Element>* elements : {&seen_, &visible_}) {
      std::sort(elements->begin(), elements->end());
      elements->erase(std::unique(elements->begin(), elements->end()), elements->end());
      std::erase_if(*elements, [](Element e) { return texel_index(e).level < 0; });
    }
  }

  Drawing finish() const override {
    FootprintPlan plan = footprint_plan(visible_, seen_);
    const std::size_t visible = plan.sampled + plan.missed;
    std::string caption =
        fmt::format("{}, in plan. Blue: {} sampled; red: {} visible and missed", place(), plan.sampled, plan.missed);
    if (visible > 0)
      caption += fmt::format(" (M/V {:.2f})", static_cast<double>(plan.sampled) / static_cast<double>(visible));
    caption += fmt::format("; green: {} hidden among them", plan.hidden);
    if (plan.leaked > 0) caption += fmt::format("; orange: {} sampled though hidden", plan.leaked);
    return {std::move(plan.picture), std::move(caption)};
  }

 private:
  std::vector<Element> seen_, visible_;
};

class FootprintOnImage final : public Footprint {
 public:
  explicit FootprintOnImage(const Settings& settings) : Footprint(settings) {
    picture_.size = {window_.width * magnification, window_.height * magnification};
    picture_.pixels.resize(static_cast<std::size_t>(picture_.size.width) *
                           static_cast<std::size_t>(picture_.size.height));
  }

  void see(const FrameView& view) override {
    double all_missed = 0, all_leaked = 0;
    for_each_pixel(view, [&](int x, int y, std::span<const ElementWeight> own, std::span<const ElementWeight> exact) {
      const auto is_in = [](std::span<const ElementWeight> list, Element element) {
        return std::binary_search(list.begin(), list.end(), ElementWeight{element, 0},
                                  [](const auto& a, const auto& b) { return a.element < b.element; });
      };
      double sampled = 0, missed = 0, leaked = 0;
      for (const ElementWeight& e : exact) (is_in(own, e.element) ? sampled : missed) += e.weight;
      for (const ElementWeight& e : own) leaked += is_in(exact, e.element) ? 0 : e.weight;
      all_missed += missed;
      all_leaked += leaked;
      fill(x, y, sampled, leaked);
    });
    missed_ = all_missed / window_.width / window_.height;
    leaked_ = all_leaked / window_.width / window_.height;
  }

  Drawing finish() const override {
    return {
        picture_,
        fmt::format("{}, magnified {} times. Each pixel, from its bottom: blue the visible weight that is "
                    "sampled, red what is missed (mean {:.3f}); orange, at the right: weight given to what cannot be "
                    "seen there (mean {:.3f})",
                    place(), magnification, missed_, leaked_)};
  }

 private:
  // The pixel as a small bar chart: the shares of the visible weight, and a bar over its right edge for leaked weight.
  void fill(int x, int y, double sampled, double leaked) {
    for (int row = 0; row < magnification; ++row) {
      const double height = (row + 0.5) / magnification;  // from the bottom
      const auto begin =
          static_cast<std::size_t>((y + 1) * magnification - 1 - row) * static_cast<std::size_t>(picture_.size.width) +
          static_cast<std::size_t>(x * magnification);
      for (int column = 0; column < magnification; ++column) {
        const bool is_leak = column == magnification - 1 && height < leaked;
        picture_.pixels[begin + static_cast<std::size_t>(column)] = is_leak            ? footprint_colors::leaked
                                                                    : height < sampled ? footprint_colors::sampled
                                                                                       : footprint_colors::missed;
      }
    }
  }

  Picture picture_;
  double missed_ = 0, leaked_ = 0;
};

}  // namespace

const PassDescription footprint_description{
    .name = "footprint",
    .summary = "What a window of pixels sees, sampled, missed or hidden, in plan or on the image.",
    .source = "Cohen-Or 1997, Fig. 9",
    .parameters = parameters,
    .asks =
        [](const Settings& settings) { return settings.text("in") == "plan" ? Questions::surface : Questions::none; },
    .problem = [](const Settings& settings, const Extent& extent) -> std::string {
      const auto beyond = [&](const char* begin, const char* size, int side) {
        return settings.integer(begin) + settings.integer(size) > side;
      };
      if (beyond("window.x", "window.width", extent.image.width) ||
          beyond("window.y", "window.height", extent.image.height)) {
        return fmt::format("its window of {} x {} pixels at ({}, {}) leaves the image of {} x {}",
                           settings.integer("window.width"), settings.integer("window.height"),
                           settings.integer("window.x"), settings.integer("window.y"), extent.image.width,
                           extent.image.height);
      }
      const bool is_large =
          std::max(settings.integer("window.width"), settings.integer("window.height")) > widest_shown;
      if (settings.text("in") == "image" && is_large) {
        return fmt::format("shows a window of {} x {} pixels magnified {} times; at most {} x {} can be",
                           settings.integer("window.width"), settings.integer("window.height"), magnification,
                           widest_shown, widest_shown);
      }
      return {};
    },
};

std::unique_ptr<PicturePass> make_footprint(const Settings& settings, const Extent&) {
  if (settings.text("in") == "plan") return std::make_unique<FootprintInPlan>(settings);
  return std::make_unique<FootprintOnImage>(settings);
}

}  // namespace moire
