// Irradiance from one point of an area light along a row of cells.
#pragma once

namespace shadow_planes {

// Seen from the light's foot on the receiver's plane, x is how far along the row a cell's middle is: x0 + step * i.
struct KernelRow {
  float x0, step;
  float square;      // of the light's distance from the row's line
  float sent, turn;  // what the light sends to x = 0, times the receiver's cosine, and how that changes with x
};

// Adds max(0, part (sent + turn x)) / (square + x^2)^2 to cells begin .. end - 1 of a row.
void add_kernel(const KernelRow& row, int begin, int end, float part, float* cells);

// Adds `part` where sent + turn x is above 0.
void add_flat(const KernelRow& row, int begin, int end, float part, float* cells);

}  // namespace shadow_planes
