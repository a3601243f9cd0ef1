// Terrain shaped by running water: every place lies above the place it drains to by a step that is the smaller the more
// land drains through it. That is the steady state of stream-power erosion against uplift, as in Braun and Willett 2013
// (doi:10.1016/j.geomorph.2012.10.008) and Cordonnier et al. 2016 (doi:10.1111/cgf.12820); it is solved for directly
// rather than by steps of time, from coarse to fine.
#pragma once

#include "grid.h"
#include "noise.h"

namespace heightfield {

struct Drainage {
  Grid<double> height;     // highest land 1; water below 0 by its depth
  Grid<int> receiver;      // index of the node it drains to; its own where water stands
  Grid<double> catchment;  // the part of the whole map that drains through the node
};

// What the solution is given: two square grids over the map.
struct Uplands {
  Grid<double> shore;      // below 0 where water stands: its depth in the unit of the heights; above 0 on land
  Grid<double> steepness;  // slope where little land drains, in any unit; above 0
};

// `side` nodes a side, at least 1; node (i, j) lies at ((i + .5) / side, (j + .5) / side) of the map.
Drainage drain(int side, const Uplands& uplands, const Noise& noise);

}  // namespace heightfield
