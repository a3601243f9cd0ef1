// What square blocks of the texture are like on average, and how far their texels are from that.
#pragma once

#include <cstddef>
#include <vector>

namespace textured_plane {

// The quadtree's nodes: block (i, j) of level l is the part of texels i 2^l .. (i + 1) 2^l - 1 by j 2^l ..
// (j + 1) 2^l - 1 that there is; one block makes up the last level.
class Blocks {
 public:
  struct Block {
    double mean[3];
    float deviation;  // no channel of a texel is farther from the mean
    float spread;     // nor is the root mean square distance from it in any channel
  };

  // `rgba`: four floats a texel. Takes about 43 bytes a texel.
  Blocks(const float* rgba, int width, int height);

  int levels() const { return static_cast<int>(levels_.size()); }
  int columns(int level) const { return levels_[static_cast<std::size_t>(level)].width; }
  int rows(int level) const { return levels_[static_cast<std::size_t>(level)].height; }
  const Block& block(int level, int i, int j) const {
    const Level& l = levels_[static_cast<std::size_t>(level)];
    return l.blocks[static_cast<std::size_t>(j) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(i)];
  }
  const Block& whole() const { return levels_.back().blocks.front(); }

 private:
  struct Level {
    int width, height;
    std::vector<Block> blocks;
  };
  std::vector<Level> levels_;
};

}  // namespace textured_plane
