// Hard pixels of few polygons, each hard in one way.
#pragma once

#include "support/hard_pixels/sketch.h"

namespace moire::test::hard {

// Triangles about a point, each sharing edges with its neighbours: nothing may be seen between them.
void shared_edges(Sketch& sketch);
// Polygons on both sides of one line that use different stretches of it.
void coincident_edges(Sketch& sketch);
// Polygons again and again, each corner moved by 1e-14 .. 1e-6 or not at all.
void nearly_coincident_edges(Sketch& sketch);
// Corners at the pixel's, on its border, at its middle, and just beside them.
void corners_on_borders(Sketch& sketch);
// Long and thin, or small all round.
void slivers(Sketch& sketch);
// The same polygon many times, begun at other corners and gone round the other way; sometimes something between.
void stacked_duplicates(Sketch& sketch);
void self_intersections(Sketch& sketch);
// Contours that wind around the same places twice, or once this way and once that way.
void fill_rules(Sketch& sketch);
// Holes that lie inside, touch the rim in a corner, or have an edge of it.
void holes(Sketch& sketch);
// Polygons that begin far on the left of the image or above it, some without a corner inside.
void edges_outside(Sketch& sketch);
// Level and upright ones, on few places so that many lie on each other.
void level_and_upright_edges(Sketch& sketch);
// Edges of 1e6 pixels, most of them through the pixel.
void large_coordinates(Sketch& sketch);

}  // namespace moire::test::hard
