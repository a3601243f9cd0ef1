// Terrain shaped by running water; see drainage.h.
#include "drainage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

namespace heightfield {
namespace {

struct Step {
  int x, y;
  double length;
};
constexpr double diagonal = 1.4142135623730951;
constexpr std::array<Step, 8> steps = {{{1, 0, 1},
                                        {0, 1, 1},
                                        {-1, 0, 1},
                                        {0, -1, 1},
                                        {1, 1, diagonal},
                                        {-1, 1, diagonal},
                                        {-1, -1, diagonal},
                                        {1, -1, diagonal}}};

// The value of a square grid at node (x, y) of another with `side` nodes a side.
double refined(const Grid<double>& grid, int side, int x, int y) {
  const double scale = static_cast<double>(grid.width) / side;
  return smooth_value(grid, (x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5);
}

// Slopes fall with the root of the catchment; from about this root on (in sides of the map) down to nothing they level
// off, since there is no stream yet.
constexpr double hillslope = 0.012;

class Solver {
 public:
  Solver(int side, const Uplands& uplands)
      : side_(side), state_{{side, side}, {side, side}, {side, side}}, steepness_(side, side) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        state_.height.at(x, y) = std::min(refined(uplands.shore, side, x, y), 0.0);
        steepness_.at(x, y) = refined(uplands.steepness, side, x, y);
      }
    // Water must have somewhere to go, even on a map too small to show any.
    if (std::none_of(state_.height.values.begin(), state_.height.values.end(), [](double h) { return h < 0; }))
      state_.height.at(side / 2, side / 2) = -1e-3;
  }

  // Land starts at these heights.
  void start(const std::function<double(int, int)>& height) {
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x)
        if (!is_water(state_.height.index(x, y))) state_.height.at(x, y) = std::max(height(x, y), 0.0);
  }

  // Raises hollows until all land drains, by flooding from the water upward (Barnes, Lehman, Mulla 2014,
  // doi:10.1016/j.cageo.2013.04.024), with a slight slope so that no place is level.
  void fill_hollows() {
    std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> open;
    std::vector<char> seen(state_.height.values.size());
    const auto reach = [&](std::size_t i) {
      seen[i] = 1;
      open.push(key(i));
    };
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (is_water(i)) reach(i);
    while (!open.empty()) {
      const std::size_t from = open.top() & 0xffffffff;
      open.pop();
      const double level = std::max(state_.height.values[from], 0.0);
      const int x = static_cast<int>(from) % side_, y = static_cast<int>(from) / side_;
      for (const Step& step : steps) {
        if (!inside(x + step.x, y + step.y)) continue;
        const std::size_t to = state_.height.index(x + step.x, y + step.y);
        if (seen[to]) continue;
        state_.height.values[to] = std::max(state_.height.values[to], level + 1e-7);
        reach(to);
      }
    }
  }

  // One round: where does all land drain, how much drains through, and so how steep may it be.
  void settle() {
    find_receivers();
    gather_catchments();
    const double spacing = 1.0 / side_;
    for (std::size_t k = order_.size(); k-- > 0;) {
      const std::size_t i = order_[k];
      const auto r = static_cast<std::size_t>(state_.receiver.values[i]);
      if (r == i) continue;
      const double slope = steepness_.values[i] / (hillslope + std::sqrt(state_.catchment.values[i]));
      state_.height.values[i] = std::max(state_.height.values[r], 0.0) + slope * run_[i] * spacing;
    }
  }

  // Makes the highest land 1; depths of water stay.
  void normalize() {
    const double top = *std::max_element(state_.height.values.begin(), state_.height.values.end());
    if (top <= 0) return;
    for (double& height : state_.height.values)
      if (height > 0) height /= top;
  }

  Drainage& state() { return state_; }

 private:
  // Orders nodes by height, in steps fine enough for a flood, then by index.
  std::uint64_t key(std::size_t i) const {
    const double height = std::clamp(state_.height.values[i], 0.0, 1e3);
    return static_cast<std::uint64_t>(height * 0x1p20) << 32 | i;
  }

  bool is_water(std::size_t i) const { return state_.height.values[i] < 0; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }

  // Each land node drains to its steepest lower neighbour.
  void find_receivers() {
    run_.assign(state_.height.values.size(), 0);
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const std::size_t i = state_.height.index(x, y);
        int& receiver = state_.receiver.values[i] = static_cast<int>(i);
        if (is_water(i)) continue;
        double steepest = 0;
        for (const Step& step : steps) {
          if (!inside(x + step.x, y + step.y)) continue;
          const std::size_t n = state_.height.index(x + step.x, y + step.y);
          const double slope = (state_.height.values[i] - std::max(state_.height.values[n], -1e-9)) / step.length;
          if (slope <= steepest) continue;
          steepest = slope;
          receiver = static_cast<int>(n);
          run_[i] = step.length;
        }
      }
  }

  // Passes each node's catchment on once all that drains into it is known; leaves the nodes in that order.
  void gather_catchments() {
    const std::size_t count = state_.height.values.size();
    std::vector<int> waiting(count, 0);
    for (std::size_t i = 0; i < count; ++i) ++waiting[static_cast<std::size_t>(state_.receiver.values[i])];
    state_.catchment.values.assign(count, 1.0 / static_cast<double>(count));
    order_.clear();
    for (std::size_t i = 0; i < count; ++i)
      if (waiting[i] == 0) order_.push_back(i);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::size_t i = order_[k];
      const auto r = static_cast<std::size_t>(state_.receiver.values[i]);
      if (r == i) continue;
      state_.catchment.values[r] += state_.catchment.values[i];
      if (--waiting[r] == 0) order_.push_back(r);
    }
  }

  int side_;
  Drainage state_;
  Grid<double> steepness_;
  std::vector<double> run_;         // distance to the receiver, in nodes
  std::vector<std::size_t> order_;  // from ridges down to the water
};

}  // namespace

Drainage drain(int side, const Uplands& uplands, const Noise& noise) {
  constexpr int coarsest = 32;
  Solver solver(side, uplands);
  if (side > coarsest) {
    const Drainage coarse = drain(side / 2, uplands, noise);
    solver.start([&](int x, int y) { return refined(coarse.height, side, x, y) * (0.95 + 0.1 * noise.white(x, y)); });
  } else {
    solver.start([&](int x, int y) { return noise.white(x, y); });
  }
  solver.fill_hollows();
  const int rounds = side > 256 ? 4 : 10;
  for (int round = 0; round < rounds; ++round) solver.settle();
  solver.normalize();
  return std::move(solver.state());
}

}  // namespace heightfield
