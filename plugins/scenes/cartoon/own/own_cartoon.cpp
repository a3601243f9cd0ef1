#include "own_cartoon.h"

#include <string_view>

#include <fmt/format.h>

#include "drawing/pen.h"
#include "ink.h"
#include "reading/paint.h"
#include "reading/path_data.h"

namespace cartoon {

namespace {

constexpr double width = 240, height = 180;

struct Shape {
  std::string_view color, data;
  double ink = 0;  // 0: filled; else a line of this width
  moire::FillRule rule = moire::FillRule::nonzero;
};

constexpr auto even_odd = moire::FillRule::even_odd;
constexpr std::string_view black = "#231f20";

// Outlines that several layers have in common.
#define FAR_HILLS "C 150 78 196 74 240 92"
#define HEAD                                                                                                    \
  "M 134 84 C 130 74 130 62 134 52 C 141 55 147 60 151 65 C 157 63 165 63 171 65 C 175 60 181 55 188 52 C 192 " \
  "62 192 74 188 84 C 190 96 180 106 161 106 C 142 106 132 96 134 84 Z"
#define BODY                                                                                                 \
  "M 144 100 C 132 116 124 136 125 156 C 125 166 132 171 142 171 L 180 171 C 190 171 197 166 197 156 C 198 " \
  "136 190 116 178 100 Z"
#define TAIL                                                                                                       \
  "M 190 160 C 206 166 222 158 222 142 C 222 130 212 126 210 116 C 209 110 213 106 217 108 C 221 110 219 114 218 " \
  "116 C 220 124 231 130 231 143 C 231 164 210 176 190 171 Z"

constexpr Shape behind[] = {
    {"#bfe3f2", "M 0 0 H 240 V 180 H 0 Z"},
};

constexpr Shape landscape[] = {
    {"#ffd24d", "M 212 34 A 16 16 0 1 1 180 34 A 16 16 0 1 1 212 34 Z"},
    {"#ffffff", "M 22 40 a 9 9 0 0 1 10 -12 a 13 13 0 0 1 25 -2 a 10 10 0 0 1 13 14 Z"},
    {"#eef6fb", "M 112 30 a 8 8 0 0 1 11 -10 a 11 11 0 0 1 20 0 q 10 -2 9 10 Z"},
    {"#a9d39b", "M 0 104 C 34 82 74 80 110 94 " FAR_HILLS " V 180 H 0 Z"},
    {"#8cc27a", "M 0 112 C 60 96 100 104 140 112 S 216 108 240 98 V 180 H 0 Z"},
    {"#74ad5e", "M 0 128 C 70 118 150 124 240 116 V 180 H 0 Z"},
    // A path that gets narrower towards the door.
    {"#e8d3a2",
     "M 62 126 C 58 136 70 142 58 152 C 48 160 40 168 36 180 H 84 C 80 166 86 158 88 150 C 90 140 72 136 73 "
     "126 Z"},
};

constexpr Shape cottage[] = {
    {"#b8553f", "M 84 34 H 94 V 58 H 84 Z"},
    // Front and side share the edge at x = 82, walls and roof those below the eaves.
    {"#f6e6c4", "M 38 76 L 60 50 L 82 76 V 126 H 38 Z"},
    {"#dcc596", "M 82 76 H 120 V 122 L 82 126 Z"},
    {"#c9604a", "M 60 50 L 104 48 L 124 76 H 82 Z"},
    {"#8f3f31", "M 60 44 L 88 77 L 82 77 L 60 51 L 38 77 L 32 77 Z"},
    {"#7a4a2e", "M 60 126 V 104 A 7.5 8 0 0 1 75 104 V 126 Z"},
    {"#f3c94b", "M 73 114 a 1.2 1.2 0 1 1 -2.4 0 a 1.2 1.2 0 1 1 2.4 0 Z"},
    {"#8fc7de", "M 43 88 H 55 V 102 H 43 Z M 92 86 H 110 V 102 H 92 Z"},
    // Frames: what lies between an even number of outlines is left open.
    {"#ffffff",
     "M 42 87 H 56 V 103 H 42 Z M 43.4 88.4 H 48.3 V 94.3 H 43.4 Z M 49.7 88.4 H 54.6 V 94.3 H 49.7 Z M 43.4 95.7 H "
     "48.3 V "
     "101.6 H 43.4 Z M 49.7 95.7 H 54.6 V 101.6 H 49.7 Z M 91 85 H 111 V 103 H 91 Z M 92.4 86.4 H 100.3 V 93.3 H 92.4 "
     "Z M 101.7 86.4 H 109.6 V 93.3 H 101.7 Z M 92.4 94.7 H 100.3 V 101.6 H 92.4 Z M 101.7 94.7 H 109.6 V 101.6 H "
     "101.7 Z",
     0, even_odd},
    {black, "M 38 76 L 60 50 L 82 76 V 126 H 38 V 76 M 82 76 H 120 V 122 L 82 126 M 60 50 L 104 48 L 124 76 H 82", 0.9},
    // Smoke.
    {"#8a9aa3", "M 89 33 C 84 26 96 22 91 15 C 88 10 94 6 98 9 C 101 12 97 15 95 13", 1.6},
};

constexpr Shape cat[] = {
    {"#e08a3c", TAIL},
    {black, TAIL, 1.2},
    {"#ea9a4a", BODY},
    {"#fbe6c8", "M 161 108 C 148 118 145 146 150 164 C 156 171 166 171 172 164 C 177 146 174 118 161 108 Z"},
    {"#c26f2a",
     "M 127 138 C 133 137 137 139 140 143 C 135 143 130 143 126.3 145 Z M 130 124 C 136 124 139 127 142 131 C "
     "137 130 132 130 128 131 Z M 195 138 C 189 137 185 139 182 143 C 187 143 192 143 196.4 145 Z M 192 124 C "
     "186 124 183 127 180 131 C 185 130 190 130 194 131 Z"},
    {black, BODY, 1.4},
    {"#fbe6c8",
     "M 138 171 C 137 162 143 159 149 160 C 155 160 158 165 157 171 Z M 165 171 C 164 165 167 160 173 160 C 179 "
     "159 185 162 184 171 Z"},
    {black,
     "M 138 171 C 137 162 143 159 149 160 C 155 160 158 165 157 171 M 165 171 C 164 165 167 160 173 160 C 179 159 "
     "185 162 184 171 M 145 170.5 L 145.5 165 M 150 170.5 L 150 165 M 172 170.5 L 172 165 M 177 170.5 L 176.5 165",
     1.1},
    {"#ea9a4a", HEAD},
    {"#f4b8b0",
     "M 137 70 C 135 65 135 60 136.5 56.5 C 140 58.5 143 61 145.5 64 C 142 65.5 139 67.5 137 70 Z M 185 70 C "
     "187 65 187 60 185.5 56.5 C 182 58.5 179 61 176.5 64 C 180 65.5 183 67.5 185 70 Z"},
    {"#c26f2a",
     "M 161 64 L 158.6 74 Q 161 76 163.4 74 Z M 154 65 L 153.4 72 Q 155.4 74 156.6 72 Z M 168 65 L 168.6 72 Q "
     "166.6 74 165.4 72 Z"},
    {"#fbe6c8",
     "M 161 88 C 152 84 144 90 145 96 C 146 103 156 104 161 100 C 166 104 176 103 177 96 C 178 90 170 84 161 "
     "88 Z"},
    {black, HEAD, 1.4},
    {"#d8ec9c",
     "M 143 82 C 146 75 154 75 156 82 C 153 87 146 87 143 82 Z M 166 82 C 168 75 176 75 179 82 C 176 87 169 87 "
     "166 82 Z"},
    {black,
     "M 143 82 C 146 75 154 75 156 82 C 153 87 146 87 143 82 Z M 166 82 C 168 75 176 75 179 82 C 176 87 169 87 166 "
     "82 Z",
     0.8},
    // Pupils with their highlights left open.
    {black,
     "M 150 77.2 C 152.4 79.4 152.4 83.4 150 85.6 C 147.6 83.4 147.6 79.4 150 77.2 Z M 172 77.2 C 174.4 79.4 174.4 "
     "83.4 172 "
     "85.6 C 169.6 83.4 169.6 79.4 172 77.2 Z M 151.2 79.6 a 0.7 0.7 0 1 0 -1.4 0 a 0.7 0.7 0 1 0 1.4 0 Z M 173.2 79.6 "
     "a "
     "0.7 0.7 0 1 0 -1.4 0 a 0.7 0.7 0 1 0 1.4 0 Z",
     0, even_odd},
    {"#d9606a", "M 157.4 88.4 C 159 87 163 87 164.6 88.4 C 164 91 162 92.4 161 93 C 160 92.4 158 91 157.4 88.4 Z"},
    {black, "M 161 92.6 C 161 99 154 101 151 97.4 M 161 92.6 C 161 99 168 101 171 97.4", 1},
    // Whiskers, thinner than a pixel in most pictures.
    {black,
     "M 148 92 C 138 89 130 88 122 89 M 148 94.4 C 138 93.6 130 94.4 122 97 M 148.6 96.6 C 140 98 132 101 125 105 M "
     "174 92 C 184 89 192 88 200 89 M 174 94.4 C 184 93.6 192 94.4 200 97 M 173.4 96.6 C 182 98 190 101 197 105",
     0.5},
};

class Painter {
 public:
  explicit Painter(Drawing& drawing) : pen_(drawing) {}

  template <std::size_t count>
  void paint(const Shape (&shapes)[count]) {
    for (const Shape& shape : shapes) paint(shape);
  }

  void paint(const Shape& shape) {
    if (shape.ink > 0) {
      draw_ink(shape.data, shape.ink, pen_);
    } else {
      draw_path_data(shape.data, pen_);
    }
    pen_.finish(parse_hex(shape.color), shape.rule);
  }

 private:
  Pen pen_;
};

// Thin triangles that meet behind the sun.
std::string rays() {
  constexpr std::string_view tips[] = {"196 -6", "212 -1", "225 5",  "235 18", "238 34", "234 50", "224 63", "211 70",
                                       "196 74", "180 70", "168 62", "158 50", "156 34", "158 18", "168 6",  "181 -2"};
  std::string data;
  bool wide = true;
  for (const std::string_view tip : tips) {
    data += fmt::format("M {} L {} 30.5 L {} 37.5 Z ", tip, wide ? 194 : 195, wide ? 198 : 197);
    wide = !wide;
  }
  return data;
}

// Pickets from x = 3 on, `pitch` apart.
std::string pickets() {
  std::string data;
  for (double x = 3; x < width; x += 9) data += fmt::format("M {} 160 v -34 l 3 -4 l 3 4 v 34 Z ", x);
  return data;
}

// Blades of grass before everything.
std::string grass() {
  std::string data;
  for (int k = 0; k < 60; ++k) {
    const double x = 4.0 * k + (k * 7 % 5) - 2, tall = 7 + k * 11 % 9, lean = k * 5 % 7 - 3;
    data += fmt::format("M {} 181 Q {} {} {} {} Q {} {} {} 181 Z ", x, x + 0.4, 181 - tall / 2, x + lean, 181 - tall,
                        x + 1.6, 181 - tall / 2, x + 1.8);
  }
  return data;
}

}  // namespace

Drawing own_cartoon() {
  Drawing drawing;
  drawing.view_box = {0, 0, width, height};
  Painter painter(drawing);
  painter.paint(behind);
  painter.paint({"#ffe79a", rays()});
  painter.paint(landscape);
  painter.paint(cottage);
  painter.paint({"#e6e9ea", "M 0 131 H 240 V 134.5 H 0 Z M 0 149 H 240 V 152.5 H 0 Z"});
  const std::string fence = pickets();
  painter.paint({"#ffffff", fence});
  painter.paint({"#5d6b70", fence, 0.5});
  painter.paint({"#4e7f41", "M 118 172 C 130 166 205 164 222 171 C 210 178 130 178 118 172 Z"});
  painter.paint(cat);
  painter.paint({"#4f8f3f", grass()});
  return drawing;
}

}  // namespace cartoon
