#include "corners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "samples.h"

namespace adaptive {

namespace {

// Rows of pixels at work at a time: keeps the samples of a tall block small.
constexpr int tile_height = 64;

using Index = std::uint32_t;

// A square of the lattice; places and sides in cells of the finest one, from the tile's corner.
struct Cell {
  int x, y, side;
  std::array<Index, 4> corners;  // upper left, upper right, lower left, lower right
};

// The new points of a cell that is cut.
enum Middle { top, left, centre, right, bottom, middles };

// A point of a lattice that some cell needs.
struct Wanted {
  int x, y;
  std::size_t cell;
  Middle middle;
};

// Some rows of a block.
class Tile {
 public:
  Tile(const moire::RenderRequest& request, const Criterion& criterion, Corners::Lattices lattices,
       moire::PixelBlock& block)
      : criterion_(criterion),
        first_(1 << lattices.first),
        finest_(1 << std::max(lattices.first, lattices.depth)),
        block_(block),
        samples_(request, block.recording()) {}

  void render(int y0, int height) {
    y0_ = y0;
    height_ = height;
    samples_.clear();
    leaves_.clear();
    look_at_first_lattice();
    while (!cells_.empty()) {
      divide();
      look_between();
    }
    add_up();
  }

 private:
  moire::SamplePoint place(int x, int y) const {
    return {block_.x0 + static_cast<double>(x) / finest_, y0_ + static_cast<double>(y) / finest_};
  }
  moire::Spacing spacing(int side) const {
    const double apart = static_cast<double>(side) / finest_;
    return {apart, apart};
  }

  void look_at_first_lattice() {
    const int side = finest_ / first_, columns = block_.width * first_, rows = height_ * first_;
    points_.clear();
    ends_.clear();
    for (int i = 0; i <= columns; ++i) {
      for (int j = rows; j >= 0; --j) points_.push_back(place(i * side, j * side));
      ends_.push_back(points_.size());
    }
    samples_.look_at(points_, ends_, spacing(side), block_.counters);
    const auto corner = [&](int i, int j) { return static_cast<Index>(i * (rows + 1) + rows - j); };
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        cells_.push_back(
            {i * side, j * side, side, {corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)}});
      }
    }
  }

  bool is_cut(const Cell& cell) const {
    if (cell.side == 1) return false;
    Range range;
    for (const Index corner : cell.corners) range.add(samples_[corner]);
    return criterion_.fires(range);
  }

  // Leaves the cells that are to be cut, and what they need to be.
  void divide() {
    wanted_.clear();
    std::size_t kept = 0;
    for (const Cell& cell : cells_) {
      if (!is_cut(cell)) {
        leaves_.push_back(cell);
        continue;
      }
      const int half = cell.side / 2;
      const auto want = [&](int x, int y, Middle middle) { wanted_.push_back({cell.x + x, cell.y + y, kept, middle}); };
      want(half, 0, top);
      want(0, half, left);
      want(half, half, centre);
      want(cell.side, half, right);
      want(half, cell.side, bottom);
      cells_[kept++] = cell;
    }
    cells_.resize(kept);
  }

  // Looks at what is wanted, each point once, and cuts the cells. Columns go upward, so that a scene may answer a point
  // from the one before; but on the borders of pixels downward, where it must not: there the points that lie between
  // are those of the pixels to the right as well, which another block may have.
  void look_between() {
    if (cells_.empty()) return;
    const auto is_before = [this](const Wanted& p, const Wanted& q) {
      if (p.x != q.x) return p.x < q.x;
      return p.x % finest_ == 0 ? p.y < q.y : p.y > q.y;
    };
    std::sort(wanted_.begin(), wanted_.end(), is_before);
    points_.clear();
    ends_.clear();
    middles_.resize(cells_.size());
    const auto next = static_cast<Index>(samples_.count());
    for (std::size_t k = 0; k < wanted_.size(); ++k) {
      const Wanted& wanted = wanted_[k];
      const bool is_in_column = k > 0 && wanted_[k - 1].x == wanted.x;
      if (k > 0 && !is_in_column) ends_.push_back(points_.size());
      if (!is_in_column || wanted_[k - 1].y != wanted.y) points_.push_back(place(wanted.x, wanted.y));
      middles_[wanted.cell][wanted.middle] = next + static_cast<Index>(points_.size()) - 1;
    }
    ends_.push_back(points_.size());
    samples_.look_at(points_, ends_, spacing(cells_.front().side / 2), block_.counters);
    cut();
  }

  void cut() {
    std::vector<Cell> quarters;
    quarters.reserve(4 * cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const auto& [x, y, side, corners] = cells_[k];
      const auto& m = middles_[k];
      const int half = side / 2;
      quarters.push_back({x, y, half, {corners[0], m[top], m[left], m[centre]}});
      quarters.push_back({x + half, y, half, {m[top], corners[1], m[centre], m[right]}});
      quarters.push_back({x, y + half, half, {m[left], m[centre], corners[2], m[bottom]}});
      quarters.push_back({x + half, y + half, half, {m[centre], m[right], m[bottom], corners[3]}});
    }
    cells_ = std::move(quarters);
  }

  // Adds each pixel's leaves to it, a point once. Points come in the order in which the pixel's own cells need them.
  void add_up() {
    const auto pixel = [this](const Cell& leaf) {
      return static_cast<std::size_t>(leaf.x / finest_) * static_cast<std::size_t>(height_) +
             static_cast<std::size_t>(leaf.y / finest_);
    };
    const std::size_t pixels = static_cast<std::size_t>(block_.width) * static_cast<std::size_t>(height_);
    std::vector<std::size_t> ends(pixels + 1);
    for (const Cell& leaf : leaves_) ++ends[pixel(leaf) + 1];
    for (std::size_t k = 1; k <= pixels; ++k) ends[k] += ends[k - 1];
    std::vector<const Cell*> sorted(leaves_.size());
    for (const Cell& leaf : leaves_) sorted[ends[pixel(leaf)]++] = &leaf;

    std::vector<double> weights(samples_.count());
    std::vector<Index> used;
    std::size_t leaf = 0;
    for (std::size_t k = 0; k < pixels; ++k) {
      used.clear();
      for (; leaf < ends[k]; ++leaf) {
        const double share = static_cast<double>(sorted[leaf]->side) / finest_;
        for (const Index corner : sorted[leaf]->corners) {
          if (weights[corner] == 0) used.push_back(corner);
          weights[corner] += share * share / 4;
        }
      }
      const int x = static_cast<int>(k) / height_, y = static_cast<int>(k) % height_;
      for (const Index point : used) {
        samples_.add_to(block_, block_.slot(block_.x0 + x, y0_ + y), point, weights[point]);
        weights[point] = 0;
      }
    }
  }

  const Criterion& criterion_;
  const int first_, finest_;  // cells along a pixel's side
  moire::PixelBlock& block_;
  int y0_ = 0, height_ = 0;
  Samples samples_;
  std::vector<Cell> cells_, leaves_;  // of one side that may be cut; those that are not
  std::vector<Wanted> wanted_;
  std::vector<std::array<Index, middles>> middles_;  // of each cell
  std::vector<moire::SamplePoint> points_;
  std::vector<std::size_t> ends_;  // of the columns in points_
};

}  // namespace

void Corners::render(moire::PixelBlock& block) const {
  Tile tile(request_, criterion_, lattices_, block);
  for (int y = block.y0; y < block.y0 + block.height; y += tile_height)
    tile.render(y, std::min(tile_height, block.y0 + block.height - y));
}

}  // namespace adaptive
