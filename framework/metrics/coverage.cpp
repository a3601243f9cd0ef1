// Which of the visible elements a method samples, and in what amounts: M/V of Cohen-Or 1997, section 7, and its
// weights.
#include <algorithm>
#include <cmath>

#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    choice(
        "against", "pixel", "column pixel",
        "what counts as visible: the exact content of the upright line through the pixels' middles, as in the paper, "
        "or that of the pixels, by the reference"),
};

constexpr Quantity quantities[] = {
    {.name = "coverage.pixels",
     .unit = "per column",
     .meaning = "P: pixels of an image column in which an element is seen",
     .is_judged = false},
    {.name = "coverage.steps",
     .unit = "per column",
     .meaning = "L: elements stepped over from a column's first hit to its last",
     .is_judged = false},
    {.name = "coverage.visible",
     .unit = "per column",
     .meaning = "V: distinct visible elements; against pixel: an element counts in each pixel where it is visible",
     .is_judged = false},
    {.name = "coverage.sampled",
     .unit = "per column",
     .meaning = "M: the visible elements that are sampled",
     .lower_is_better = false,
     .is_judged = false},
    {.name = "coverage.hits",
     .unit = "per column",
     .meaning = "queries answered by an element, or runs of a line",
     .is_judged = false},
    {.name = "coverage.ratio", .unit = "", .meaning = "M / V", .lower_is_better = false, .is_main = true},
    {.name = "coverage.leak",
     .unit = "",
     .meaning = "mean over pixels of the weight given to elements that are not visible there"},
    {.name = "coverage.weight_error",
     .unit = "",
     .meaning = "mean over pixels of half the sum over elements of |weight - exact weight|"},
};

struct ColumnSums {
  std::size_t pixels = 0, visible = 0, sampled = 0;
  double leak = 0, weight_error = 0;
};

// Calls visit(element, weight, exact) for every element that either list has.
template <class Visit>
void pair_up(std::span<const ElementWeight> own, std::span<const ElementWeight> exact, Visit visit) {
  std::size_t a = 0, b = 0;
  while (a < own.size() || b < exact.size()) {
    const bool take_own = b == exact.size() || (a < own.size() && own[a].element <= exact[b].element);
    const bool take_exact = a == own.size() || (b < exact.size() && exact[b].element <= own[a].element);
    visit(take_own ? own[a].element : exact[b].element, take_own ? own[a].weight : 0.0,
          take_exact ? exact[b].weight : 0.0);
    a += take_own;
    b += take_exact;
  }
}

// Each element once, and of the sampled ones those that are visible.
void keep_distinct(std::vector<Element>& visible, std::vector<Element>& sampled) {
  for (std::vector<Element>* elements : {&visible, &sampled}) {
    std::sort(elements->begin(), elements->end());
    elements->erase(std::unique(elements->begin(), elements->end()), elements->end());
  }
  std::erase_if(sampled, [&](Element e) { return !std::binary_search(visible.begin(), visible.end(), e); });
}

class Coverage final : public Metric {
 public:
  explicit Coverage(const Settings& settings)
      : against_(settings.text("against") == "column" ? Against::column : Against::pixel) {}

  Against against() const override { return against_; }

  void begin(ImageSize size) override { columns_.assign(static_cast<std::size_t>(size.width), {}); }

  void block(const PixelBlock& block, const MergedBlock& exact) override {
    std::vector<ElementWeight> own;
    std::vector<Element> visible, sampled;
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      ColumnSums& sums = columns_[static_cast<std::size_t>(x)];
      visible.clear();
      sampled.clear();
      for (int y = block.y0; y < block.y0 + block.height; ++y) {
        const std::size_t slot = block.slot(x, y);
        merge(block, slot, own);
        if (!own.empty() && own.back().element != background) ++sums.pixels;
        pair_up(own, exact.pixel(slot), [&](Element element, double weight, double exact_weight) {
          sums.weight_error += std::abs(weight - exact_weight) / 2;
          if (exact_weight == 0) sums.leak += weight;
          if (element == background) return;
          if (exact_weight != 0) visible.push_back(element);
          if (weight != 0 && (exact_weight != 0 || against_ == Against::column)) sampled.push_back(element);
        });
      }
      if (against_ == Against::column) keep_distinct(visible, sampled);
      sums.visible = visible.size();
      sums.sampled = sampled.size();
    }
  }

  std::vector<Measurement> finish(const Judged& judged) override {
    ColumnSums all;
    for (const ColumnSums& column : columns_) {
      all.pixels += column.pixels;
      all.visible += column.visible;
      all.sampled += column.sampled;
      all.leak += column.leak;
      all.weight_error += column.weight_error;
    }
    const auto width = static_cast<double>(judged.picture.size.width);
    const auto pixels = static_cast<double>(judged.picture.pixels.size());
    const auto per_column = [&](auto count) { return static_cast<double>(count) / width; };
    return {{"coverage.pixels", per_column(all.pixels)},
            {"coverage.steps", per_column(judged.counters.steps)},
            {"coverage.visible", per_column(all.visible)},
            {"coverage.sampled", per_column(all.sampled)},
            {"coverage.hits", per_column(judged.counters.hits)},
            {"coverage.ratio", static_cast<double>(all.sampled) / static_cast<double>(all.visible)},
            {"coverage.leak", all.leak / pixels},
            {"coverage.weight_error", all.weight_error / pixels}};
  }

 private:
  Against against_;
  std::vector<ColumnSums> columns_;
};

}  // namespace

const PassDescription coverage_description{
    .name = "coverage",
    .summary = "Which of the visible elements are sampled, and in what amounts.",
    .source = "Cohen-Or 1997, section 7: P, L, V, M and M/V; leak and weight error are ours",
    .parameters = parameters,
    .quantities = quantities,
    .asks =
        [](const Settings& settings) {
          return settings.text("against") == "column" ? Questions::lines : Questions::none;
        },
};

std::unique_ptr<Metric> make_coverage(const Settings& settings) { return std::make_unique<Coverage>(settings); }

}  // namespace moire
