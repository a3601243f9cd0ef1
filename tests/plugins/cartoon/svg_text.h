// Small SVG documents, and what their readers say.
#pragma once

#include <string>

#include <fmt/format.h>

#include "message_of.h"
#include "plugins/cartoon/drawn.h"
#include "reading/reading.h"

namespace moire::test {

// On one line, with a view box.
inline std::string document(std::string_view content) {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\">{}</svg>", content);
}

inline cartoon::Drawing read(std::string_view text, cartoon::Unmodelled unmodelled = cartoon::Unmodelled::refuse) {
  return cartoon::read_drawing(text, "a.svg", unmodelled);
}

inline std::string problem_of(std::string_view text, cartoon::Unmodelled unmodelled = cartoon::Unmodelled::refuse) {
  return message_of([&] { read(text, unmodelled); });
}

// A line for each layer: "#rrggbb M 0,0 L ...", and "evenodd" before its outline.
inline std::string layers_of(const cartoon::Drawing& drawing) {
  std::string text;
  for (std::size_t k = 0; k < drawing.layers.size(); ++k) {
    const auto& [r, g, b] = drawing.layers[k].color;
    text += fmt::format("{}#{:02x}{:02x}{:02x} {}{}", k == 0 ? "" : "\n", r, g, b,
                        drawing.layers[k].rule == FillRule::even_odd ? "evenodd " : "", shown(drawing, k));
  }
  return text;
}

// Of elements in a document.
inline std::string layers(std::string_view content, cartoon::Unmodelled unmodelled = cartoon::Unmodelled::refuse) {
  return layers_of(read(document(content), unmodelled));
}

}  // namespace moire::test
