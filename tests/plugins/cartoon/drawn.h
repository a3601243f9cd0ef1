// Drawings as texts that tests compare.
#pragma once

#include <string>

#include <fmt/format.h>

#include "drawing/drawing.h"
#include "drawing/pen.h"
#include "reading/path_data.h"

namespace moire::test {

// "M 1,2 L 3,4 Q ...": capital letters, absolute places; an arc as its centre, its vectors, its angles and its end.
inline std::string shown(const cartoon::Drawing& drawing, std::size_t layer = 0) {
  constexpr std::string_view letters = "MLQCA";
  std::string text;
  std::size_t point = drawing.layers[layer].first_point;
  for (std::size_t v = drawing.layers[layer].first_verb; v < drawing.verb_end(layer); ++v) {
    text += fmt::format("{}{}", text.empty() ? "" : " ", letters[static_cast<std::size_t>(drawing.verbs[v])]);
    for (std::size_t k = 0; k < points_of(drawing.verbs[v]); ++k, ++point) {
      text += fmt::format(" {:g},{:g}", drawing.points[point].x, drawing.points[point].y);
    }
  }
  return text;
}

inline cartoon::Drawing drawn(std::string_view path_data, const Affine& transform = {}) {
  cartoon::Drawing drawing;
  cartoon::Pen pen(drawing);
  pen.set_transform(transform);
  cartoon::draw_path_data(path_data, pen);
  pen.finish({}, FillRule::nonzero);
  return drawing;
}

}  // namespace moire::test
